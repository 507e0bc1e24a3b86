#!/usr/bin/env bash
# tests/check_pages finds each kind of fault in a small project.
set -u
check=$(dirname "$(realpath "$0")")/check_pages
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
mkdir -p "$copy/core/mesh" "$copy/tests/consumer" "$copy/build" "$copy/data"
printf 'int main() {}\n' >"$copy/tests/consumer/example.cpp"
printf '// See core/mesh/mesh.h, as tests/consumer does.\n' >"$copy/core/mesh/mesh.h"
printf '# core\n\n## The first `room`\n\n[top](../README.md#use-it), `mesh/mesh.h`\n' >"$copy/core/README.md"
printf '[nowhere](nowhere.md)\n' >"$copy/build/README.md"
readme=$(printf '%s\n' '# project' '## Use it' '[core](core/README.md#the-first-room), `core/mesh`, `result/x`' \
  '```cpp' 'int main() {}' '```' '[data](data)')
status=0

finds() {  # file, what is said of it, text in it, what replaces that text
  local path=$copy/$1
  local before said
  before=$(cat "$path")
  printf '%s\n' "${before/"$3"/$4}" >"$path"
  if said=$("$check" "$copy") || [ "$said" != "$2" ]; then
    echo "$4 in $1: '$said' instead of '$2'"
    status=1
  fi
  printf '%s\n' "$before" >"$path"
}

printf '%s\n' "$readme" >"$copy/README.md"
"$check" "$copy" || { echo "the small project is refused"; status=1; }
finds README.md 'README.md:3: no such file: core/READ.md#the-first-room' core/README.md core/READ.md
finds README.md 'README.md:3: no such heading: core/README.md#room' '#the-first-room' '#room'
finds README.md 'README.md:7: no such file: dates' '(data)' '(dates)'
finds README.md 'README.md:3: no such file: core/graph/graph.h' 'core/mesh`' 'core/graph/graph.h`'
finds README.md 'README.md: its example is not tests/consumer/example.cpp' 'int main' 'long main'
finds core/README.md 'core/README.md:5: no such file: mesh/graph.h' mesh/mesh.h mesh/graph.h
finds core/README.md 'core/README.md:5: no such heading: ../README.md#use' '#use-it' '#use'
finds core/mesh/mesh.h 'core/mesh/mesh.h:1: no such file: core/mesh.h' core/mesh/mesh.h core/mesh.h
exit $status
