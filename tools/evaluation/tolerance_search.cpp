#include "tools/evaluation/tolerance_search.h"

#include <algorithm>
#include <utility>

#include "core/base/bounding_box.h"
#include "tools/evaluation/distances/distance_bounds.h"
#include "tools/evaluation/vertex_search.h"

namespace geolloyd {
namespace {

// Of both ways. A remesh without triangles is as far as the mesh is large.
DistanceBounds bounds_between(const Mesh& mesh, const Mesh& remesh, double tolerance,
                              Executor& executor) {
  if (remesh.triangles.empty()) {
    const BoundingBox box = bounding_box(referenced_positions(mesh, executor));
    return {norm(box.extent()), norm(box.extent())};
  }
  return certify_distance(executor, mesh, remesh, tolerance).two_sided();
}

}  // namespace

ToleranceSearch search_within(double tolerance, RemeshCourse course) {
  const std::size_t most = std::max<std::size_t>(100'000, 4 * course.mesh.vertex_count());
  VertexSearch search(tolerance, most);
  ToleranceSearch found;
  while (const auto vertices = search.next()) {
    course.options.vertex_count = *vertices;
    TimedRemesh made = run(course);
    if (course.hooks.stage) course.hooks.stage("measuring the remesh");
    const Mesh& remesh = made.remesh.mesh;
    const bool is_interrupted = made.remesh.interrupted;
    const DistanceBounds bounds =
        bounds_between(course.mesh, remesh, tolerance, course.runtime.executor());
    if (search.add({remesh.vertex_count(), bounds.upper, bounds.lower})) {
      found.best = std::move(made);
      found.bounds = bounds;
    }
    if (!is_interrupted) continue;
    found.best.remesh.interrupted = true;
    break;
  }
  found.trials = search.trials();
  return found;
}

}  // namespace geolloyd
