#!/usr/bin/env bash
# tests/check_layers.sh accepts the project, and finds what must not be in a copy of it.
# `check_layers_test.sh FOLDER`: the project's folder.
set -u
check=$1/tests/check_layers.sh
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
(cd "$1" && find core parallel tools bench tests \( -name '*.h' -o -name '*.cpp' \) -print0 |
  tar --create --null --files-from=-) | tar --extract --directory="$copy"
status=0

"$check" "$copy" || { echo "the project itself is refused"; status=1; }

finds() {  # file, what is said of it, line that is added to it
  local path=$copy/$1
  local before said
  before=$(cat "$path" 2>/dev/null)
  mkdir -p "$(dirname "$path")"
  printf '%s' "${before:+$before$'\n'}$3"$'\n' >"$path"
  if said=$("$check" "$copy") || ! grep -qF "$2: $3" <<<"$said"; then
    echo "not found: $3 in $1"
    status=1
  fi
  if [ -n "$before" ]; then printf '%s\n' "$before" >"$path"; else rm "$path"; fi
}

finds core/mesh/mesh.h 'includes from a later room' '#include "core/graph/graph.h"'
finds core/regions/tessellation.cpp 'includes what is no door of its room' '#include "core/dual/surface_scan.h"'
finds tools/cli/number_option.cpp 'includes what is no door of its room' '#include "core/graph/mesh_arcs.h"'
finds core/graph/graph.cpp 'includes what is no door of its room' '#include "core/formats/ply/ply_header.h"'
finds core/regions/tessellation.cpp 'includes from a later room' '#include "parallel/threads/scheduler.h"'
finds parallel/threads/scheduler.h 'includes from a later room' '#include "parallel/engine/parallel_engine.h"'
finds tools/words/names.h 'includes from a later room' '#include "tools/cli/number_option.h"'
finds tools/cli/number_option.h 'includes from a later room' '#include "tools/run/stages.h"'
finds tests/support/naive.h 'includes from a later room' '#include "tests/fuzz/soup.h"'
finds tools/run/input.h 'includes from a later room' '#include "tools/laboratory/laboratory.h"'
finds core/base/types.h 'includes from no room' '#include "types.h"'
finds core/base/types.h 'names a thread' '#include <thread>'
finds core/graph/graph.h 'names an atomic' '#include <atomic>'
finds core/text/file_io.cpp 'prints or exits' '  std::printf("done");'
finds parallel/engine/local_region.h 'starts threads' '#pragma omp parallel'
finds core/mesh/mesh.h 'knows Embree' '#include <embree4/rtcore.h>'
finds tools/run/stages.h 'knows Cairo' '#include <cairo/cairo.h>'
finds tools/report/report.h 'knows CLI11' '#include <CLI/CLI.hpp>'
finds tools/report/report.h 'names a struct of the command line' 'struct RelaxArguments;'
finds bench/suites/main.cpp 'needs the tools' '#include "tools/words/names.h"'
finds core/include/geolloyd/mesh.h 'includes from a later room' '#include "geolloyd/threads.h"'
finds parallel/include/geolloyd/threads.h 'is public, but includes what is not' '#include "core/base/types.h"'
finds core/attic/old.h 'the folder is not in the table of tests/check_layers.sh' '#include "core/base/types.h"'
"$check" "$copy" || { echo 'the copy did not become whole again'; status=1; }

rm "$copy/core/repair/repair.h"
"$check" "$copy" | grep -qF 'core/repair/repair.h: is a door' || { echo 'a missing door is not found'; status=1; }
rm -r "$copy/core/shapes"
"$check" "$copy" | grep -qF 'core/shapes: is in the table' || { echo 'a missing room is not found'; status=1; }
exit $status
