#!/usr/bin/env bash
# bench/record replaces one table of a page, and nothing where it cannot.
set -u
record=$(dirname "$(realpath "$0")")/../bench/record
pages=$(mktemp -d)
trap 'rm -rf "$pages"' EXIT
status=0

expect() {  # what is tried, the page as it is to be
  if ! diff "$pages/page.md" - <<<"$2"; then
    echo "$1"
    status=1
  fi
}

into() { "$record" --results "$pages" "$@" >/dev/null 2>&1; }

page_with() {  # what the first table holds
  printf '%s\n' '# Page' '<!-- table a -->' "$@" '<!-- end -->' 'what follows' '<!-- table b -->' 'other' '<!-- end -->'
}

page_with 'old' >"$pages/page.md"
into page a false && { echo "a command that fails is recorded"; status=1; }
expect "a command that fails changes the page" "$(page_with 'old')"
into page c touch "$pages/touched" && { echo "a table that is not on the page is recorded"; status=1; }
[ ! -e "$pages/touched" ] || { echo "the command runs, though its table has no place"; status=1; }
into page a echo '| \1 | x |' || { echo "a table is refused"; status=1; }
sed -i 's/^.*; commit .*$/machine/' "$pages/page.md"
expect "the table is not what it should be" \
  "$(page_with "\`bench/record page a echo '| \\1 | x |'\`" '' 'machine' '' '| \1 | x |')"
exit $status
