#!/usr/bin/env bash
# The order of the rooms, and what each room may know. `check_layers.sh FOLDER` looks at the project
# in that folder, prints each line that breaks a rule, and fails if there is one.
set -u
cd "$1" || exit 1

# tests/consumer is somebody else's project.
mapfile -d '' files < <(find core parallel tools bench tests \( -path tests/consumer -o -name node_modules \) -prune -o \
  \( -name '*.h' -o -name '*.cpp' \) -print0)
awk '
# A file includes only from its own room and from the rooms above it.
function table() {
  return "core/include/geolloyd " \
         "core/base core/text core/mesh core/repair core/formats core/shapes core/dual " \
         "core/surface/substrate core/surface/sizing core/surface/cells core/surface/features " \
         "core/surface/sites core/surface/result " \
         "core/graph core/voronoi core/seeds core/lloyd core/regions core/start core/course core/library " \
         "parallel/include/geolloyd parallel/threads parallel/engine parallel/surface parallel/library " \
         "tools/include/geolloyd tools/words tools/evaluation tools/render tools/python " \
         "tools/system tools/files tools/cli tools/run tools/report tools/experiments tools/view " \
         "tools/commands " \
         "bench/support bench/suites bench/studies " \
         "tests/support tests/base tests/mesh tests/repair tests/formats tests/shapes tests/graph " \
         "tests/voronoi tests/seeds tests/lloyd tests/regions tests/surface tests/start tests/library tests/parallel tests/evaluation " \
         "tests/program tests/view tests/golden tests/work tests/fuzz"
}

# What no line of a room may do, but in the rooms named last.
function rules() {
  forbid("^core/", "names a thread", "<(thread|mutex|future)>|std::(thread|jthread|mutex|async)", "")
  forbid("^core/", "names an atomic", "<atomic>|std::atomic", "^core/base$")
  forbid("^(core|parallel)/", "prints or exits",
         "std::(cout|cerr|clog|exit|abort)|(^|[^a-z_])f?printf[(]|fputs[(]", "")
  forbid("", "starts threads", "<(tbb|oneapi)/|<omp[.]h>|#pragma omp|std::(jthread|async)",
         "^parallel/threads$")
  forbid("", "knows Embree", "<embree", "^tools/(evaluation|render)$")
  forbid("", "knows Cairo", "<cairo", "^tools/render$")
  forbid("", "knows Boost", "<boost/", "^tools/view$")
  forbid("", "knows CLI11", "<CLI/", "^tools/(cli|commands)$")
  forbid("/include/", "is public, but includes what is not", "#include \"(core|parallel|tools)/", "")
  forbid("^bench/", "needs the tools", "#include \"tools/", "")
}

function forbid(where, what, pattern, except) {
  where_[++count_] = where
  what_[count_] = what
  pattern_[count_] = pattern
  except_[count_] = except
}

function complain(what) {
  printf "%s:%d: %s: %s\n", FILENAME, FNR, what, $0
  failed = 1
}

function folder(path) {
  sub("/[^/]*$", "", path)
  return path
}

# The room of a header that is included as "geolloyd/NAME.h", as users do.
function room_of(header) {
  return header in public_room ? public_room[header] : folder(header)
}

BEGIN {
  rooms = split(table(), names, " ")
  for (i = 1; i <= rooms; ++i) place[names[i]] = i
  rules()
  for (i = 1; i < ARGC; ++i) {
    header = ARGV[i]
    if (sub("^.*/include/", "", header)) public_room[header] = folder(ARGV[i])
  }
}

FNR == 1 {
  room = folder(FILENAME)
  seen[room] = 1
  if (!(room in place)) complain("the folder is not in the table of " self)
  for (i = 1; i <= count_; ++i) {
    holds[i] = room ~ where_[i] && (except_[i] == "" || room !~ except_[i])
  }
}

/^#include "/ {
  split($0, part, "\"")
  other = room_of(part[2])
  if (!(other in place)) {
    complain("includes from no room")
  } else if (place[other] > place[room]) {
    complain("includes from a later room")
  }
}

{
  for (i = 1; i <= count_; ++i) {
    if (holds[i] && $0 ~ pattern_[i]) complain(what_[i])
  }
}

END {
  for (i = 1; i <= rooms; ++i) {
    if (names[i] in seen) continue
    printf "%s: is in the table of %s, but holds no source\n", names[i], self
    failed = 1
  }
  exit failed
}
' self=tests/check_layers.sh "${files[@]}"
