#!/usr/bin/env bash
# Each room keeps to its own: core starts no thread and prints nothing, only tools knows the command
# line, Embree and pictures, and nobody includes from a later room.
set -u
cd "$1" || exit 1
status=0

forbid() {  # folder, what, pattern
  local found
  found=$(grep -rnE --include='*.h' --include='*.cpp' "$3" "$1")
  if [ -n "$found" ]; then
    printf '%s: %s\n%s\n' "$1" "$2" "$found"
    status=1
  fi
}

forbid core 'names a thread' '<(thread|mutex|future|omp\.h|tbb/)|#pragma omp|std::(thread|mutex|async)'
forbid core 'prints or exits' 'std::(cout|cerr|clog|exit|abort)|\bprintf\(|\bstd::printf|fputs\('
forbid core 'includes from a later room' '#include "(parallel|tools|bench|tests)/'
forbid parallel 'includes from a later room' '#include "(tools|bench|tests)/'
for room in core parallel bench; do forbid "$room" 'knows Embree' '<embree'; done
exit $status
