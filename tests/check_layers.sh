#!/usr/bin/env bash
# The order of the rooms, their doors, and what each room may know. `check_layers.sh FOLDER` looks at
# the project in that folder, prints each line that breaks a rule, and fails if there is one.
set -u
cd "$1" || exit 1

# A room a line, in order: a file includes only from its own room and from the rooms above it.
# After the colon, the doors: the headers, without ".h", that other rooms may include; nothing after
# it: there are none. Without a colon all are doors. Tests and benchmarks may look behind them.
export rooms='
core/include/geolloyd
core/base
core/text
core/mesh
core/seams: cut_apart places stitching
core/properties
core/fields: cross_field curvature_field metric_mean tangent_field tangent_field_file tangent_plane
core/repair: crossing_triangles crossings repair
core/formats: corner_properties mesh_formats mesh_io mesh_readers mesh_writers vertex_list welder
core/formats/gltf: base64
core/formats/ply:
core/shapes: shapes
core/dual: dual_mesh region_surface seed_insertion
core/surface/substrate: coarse_mesh fine_mesh surface_input
core/surface/sizing: curvature equal_error field_metric recipe sizing
core/surface/cells: cell_labels cell_pieces moments nearest_label paired_surface_engine reference_surface_engine surface_engine
core/surface/features: curve_sites degrees edge_network patches small_features
core/surface/creases: creases edge_angles
core/surface/sites: site_balance site_levels
core/surface/fit: asked_areas curve_fit fit_functional largest_distances lbfgs sample_projection surface_fit surface_samples
core/surface/flips: edge_flips glides
core/surface/result: remesh site_places
core/graph: components graph mesh_graph
core/voronoi: dijkstra energy fingerprint forest growing_search partition subtree
core/seeds: nearest_nodes seed_file seed_places seeds
core/lloyd: engine paired_engine reference_engine relaxation seed_move
core/regions: graph_dual regions_of_nodes tessellation
core/start: first_seeds
core/course
core/library
parallel/include/geolloyd
parallel/threads: atomic_key available_cores control_groups scheduler
parallel/engine: parallel_engine parallel_growing_search
parallel/surface
parallel/library
tools/include/geolloyd
tools/words
tools/evaluation/distances: closest_places distance_bounds embree_scene point_queries surface_distance
tools/evaluation: attribute_transfer ground_truth likeness metric_quality remesh_figures statistics tolerance_search
tools/render: labels painters panel picture sheet surface_colours view
tools/python
tools/system
tools/files
tools/cli: choice_option cli_fwd folder_option help_pages memory_option number_option reading_options relax_arguments remesh_arguments repair_arguments suggestion summary_options
tools/run: checkpoint dual frames input memory_need quality remesh remesh_run result resumable seed_source stages work_queue
tools/report
tools/view: assets bundle layers page page_contents
tools/view/session: saving session
tools/view/http: http_server
tools/laboratory: laboratory
tools/commands
bench/support
bench/zoo
bench/suites
bench/studies
tests/support
tests/base
tests/mesh
tests/repair
tests/formats
tests/shapes
tests/graph
tests/voronoi
tests/seeds
tests/lloyd
tests/regions
tests/surface
tests/start
tests/library
tests/parallel
tests/evaluation
tests/program
tests/view
tests/golden
tests/work
tests/zoo
tests/fuzz'

# tests/consumer is somebody else's project.
mapfile -d '' files < <(find core parallel tools bench tests \( -path tests/consumer -o -name node_modules \) -prune -o \
  \( -name '*.h' -o -name '*.cpp' \) -print0)
awk '
# What no line of a room may do, but in the rooms named last.
function rules() {
  forbid("^core/", "names a thread", "<(thread|mutex|future)>|std::(thread|jthread|mutex|async)", "")
  forbid("^core/", "names an atomic", "<atomic>|std::atomic", "^core/base$")
  forbid("^(core|parallel)/", "prints or exits",
         "std::(cout|cerr|clog|exit|abort)|(^|[^a-z_])f?printf[(]|fputs[(]", "")
  forbid("", "starts threads", "<(tbb|oneapi)/|<omp[.]h>|#pragma omp|std::(jthread|async)",
         "^parallel/threads$")
  forbid("", "knows Embree", "<embree", "^tools/(evaluation/distances|render)$")
  forbid("", "knows Cairo", "<cairo", "^tools/render$")
  forbid("", "knows Boost", "<boost/", "^tools/view/http$")
  forbid("", "knows CLI11", "<CLI/", "^tools/(cli|laboratory|commands)$")
  forbid("/include/", "is public, but includes what is not", "#include \"(core|parallel|tools)/", "")
  forbid("^tools/", "names a struct of the command line",
         "(^|[^A-Za-z_])[A-Z][a-z][A-Za-z]*Arguments([^A-Za-z_]|$)",  # RTC...Arguments are Embree
         "^tools/(cli|laboratory|commands)$")
  forbid("^bench/", "needs the tools", "#include \"tools/", "")
}

function forbid(where, what, pattern, except) {
  where_[++count_] = where
  what_[count_] = what
  pattern_[count_] = pattern
  except_[count_] = except
}

function read_table(  lines, part, doors, i, k) {
  rooms = split(substr(ENVIRON["rooms"], 2), lines, "\n")
  for (i = 1; i <= rooms; ++i) {
    split(lines[i], part, /: ?/)
    names[i] = part[1]
    place[part[1]] = i
    for (k = split(part[2], doors, " "); k > 0; --k) {
      door[part[1], doors[k] ".h"]
      missing[part[1] "/" doors[k] ".h"]
    }
    has_doors[part[1]] = index(lines[i], ":")
  }
}

function complain(what) {
  printf "%s:%d: %s: %s\n", FILENAME, FNR, what, $0
  failed = 1
}

function name_of(path) {
  sub("^.*/", "", path)
  return path
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
  read_table()
  rules()
  for (i = 1; i < ARGC; ++i) {
    delete missing[ARGV[i]]
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
  } else if (other != room && has_doors[other] && room !~ /^(bench|tests)/ && !((other, name_of(part[2])) in door)) {
    complain("includes what is no door of its room")
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
  for (header in missing) {
    printf "%s: is a door in the table of %s, but no file\n", header, self
    failed = 1
  }
  exit failed
}
' self=tests/check_layers.sh "${files[@]}"
