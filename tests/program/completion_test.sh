#!/usr/bin/env bash
# What `geolloyd completion bash` completes, and what `geolloyd man` names. Argument: the program.
set -euo pipefail
program=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
touch scan.ply "other scan.ply" notes.txt
fail() { echo "$*"; exit 1; }

"$program" completion bash >script
# shellcheck disable=SC1091
source ./script
complete -p geolloyd >/dev/null || fail "the script completes nothing"

completed() {  # the words of a command line whose last one is to be completed
  COMP_WORDS=("$@")
  COMP_CWORD=$(($# - 1))
  COMPREPLY=()
  _geolloyd
  printf '%s|' "${COMPREPLY[@]}"
}

expect() {  # what comes out, then the words
  local expected=$1
  shift
  local found
  found=$(completed "$@")
  [ "$found" = "$expected" ] || fail "$*: '$found' instead of '$expected'"
}

expect "relax|" geolloyd rela
expect "remesh|remesh-all|" geolloyd reme
expect "--version|" geolloyd --v
expect "parallel|reference|" geolloyd remesh scan.ply --engine ""
expect "reference|" geolloyd remesh scan.ply --engine = r
expect "auto|off|" geolloyd remesh scan.ply --features ""
expect "--features|--feature-labels|--feature-edges|" geolloyd remesh --feature
expect "scan.ply|" geolloyd remesh sca
expect "other scan.ply|" geolloyd remesh scan.ply -o oth
expect "curvature|cross|" geolloyd relax scan.ply --vfield c
expect "creature|cube|cylinder|" geolloyd generate c
expect "|" geolloyd remesh scan.ply --vertices ""
expect "|" geolloyd no-such-command x

"$program" man >geolloyd.1
commands=$("$program" --help | sed -n '/^Subcommands:/,$ s/^  \([a-z][a-z-]*\) .*/\1/p')
[ "$(wc -w <<<"$commands")" -ge 16 ] || fail "too few commands: $commands"
for command in $commands; do
  grep -q "^\.SS ${command//-/\\\\-}$" geolloyd.1 || fail "the manual lacks $command"
  for option in $("$program" "$command" --help | grep -o -- '^  .*' | grep -oE -- '--[a-z][a-z-]+' | sort -u); do
    grep -qF -- "${option//-/\\-}" geolloyd.1 || fail "the manual lacks $command $option"
  done
done
if command -v groff >/dev/null; then
  warnings=$(groff -man -Tutf8 -ww geolloyd.1 2>&1 >page)
  [ -z "$warnings" ] || fail "groff: $warnings"
  grep -q "The exit status is 0" page || fail "the page is empty"
fi
