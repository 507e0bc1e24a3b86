#include "core/course/remesh_course.h"

#include <optional>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/course/remesh_warnings.h"
#include "core/mesh/mesh_measure.h"
#include "core/repair/crossings.h"
#include "core/surface/result/remesh.h"
#include "core/surface/sizing/sizing.h"

namespace geolloyd {

std::size_t expected_vertices(const RemeshCourse& course) {
  const RemeshOptions& options = course.options;
  if (options.vertex_count > 0) return options.vertex_count;
  Executor& executor = course.runtime.executor();
  double spacing = options.edge_length;
  if (!options.sizing.edge_lengths.empty() || !options.field.empty()) {
    spacing = find_sizing(course.mesh, course.edges, options, executor).spacing;
  }
  double area = 0;
  for (const double a : triangle_areas(course.mesh, course.edges.duplicates, executor)) area += a;
  return expected_sites(area, spacing);
}

TimedRemesh run(RemeshCourse course) {
  const CourseHooks& hooks = course.hooks;
  if (hooks.budget && course.bytes)
    hooks.budget(course.bytes(expected_vertices(course), course.options));
  if (hooks.stage) hooks.stage("preparing the surface");
  const Stopwatch start;
  std::optional<Stopwatch> first_move;
  Stopwatch last_move;
  const auto watch = std::move(course.options.progress);
  course.options.progress = [&](const RemeshProgress& progress) {
    last_move = Stopwatch();
    if (!first_move) first_move = last_move;
    const bool goes_on = !watch || watch(progress);
    return goes_on && (!hooks.keep_going || hooks.keep_going());
  };
  TimedRemesh timed;
  Executor& executor = course.runtime.executor();
  InputSigns signs = find_signs(course.mesh, course.edges, executor);
  timed.remesh =
      make_remesh(course.mesh, course.edges, course.options, course.runtime, course.release_edges);
  timed.remesh.self_intersections = find_crossings(timed.remesh.mesh, executor);
  if (!timed.remesh.self_intersections.empty()) {
    signs.has_self_intersections = !find_crossings(course.mesh, executor).empty();
  }
  timed.remesh.warnings = find_warnings(course.mesh, signs, course.options, timed.remesh);
  timed.seconds.prepare = first_move.value_or(last_move).since(start);
  timed.seconds.move = last_move.since(first_move.value_or(last_move));
  timed.seconds.assemble = last_move.seconds();
  return timed;
}

}  // namespace geolloyd
