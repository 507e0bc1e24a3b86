#include "tools/evaluation/tolerance_search.h"

#include <algorithm>
#include <utility>

#include "core/base/bounding_box.h"
#include "tools/evaluation/distances/surface_distance.h"
#include "tools/evaluation/vertex_search.h"

namespace geolloyd {
namespace {

// The largest distance of both ways. A remesh without triangles is as far as the mesh is large.
double distance_between(const Mesh& mesh, const Mesh& remesh, Executor& executor) {
  constexpr std::size_t samples = 200'000;
  if (remesh.triangles.empty()) {
    const BoundingBox box = bounding_box(referenced_positions(mesh, executor));
    return norm(box.extent());
  }
  return measure_distance(executor, mesh, remesh, samples).two_sided().largest;
}

}  // namespace

ToleranceSearch search_within(double tolerance, RemeshCourse course) {
  const std::size_t most = std::max<std::size_t>(100'000, 4 * course.mesh.vertex_count());
  VertexSearch search(tolerance, most);
  TimedRemesh best;
  while (const auto vertices = search.next()) {
    course.options.vertex_count = *vertices;
    TimedRemesh made = run(course);
    if (course.hooks.stage) course.hooks.stage("measuring the remesh");
    const Mesh& remesh = made.remesh.mesh;
    const bool is_interrupted = made.remesh.interrupted;
    const double distance = distance_between(course.mesh, remesh, course.runtime.executor());
    if (search.add({remesh.vertex_count(), distance})) best = std::move(made);
    if (!is_interrupted) continue;
    best.remesh.interrupted = true;
    break;
  }
  return {std::move(best), search.trials()};
}

}  // namespace geolloyd
