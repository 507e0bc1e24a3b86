#include "tools/evaluation/distances/closest_places.h"

#include "core/base/loops.h"
#include "core/mesh/closest_on_triangle.h"
#include "tools/evaluation/distances/point_queries.h"

namespace geolloyd {

std::vector<SurfacePoint> closest_places(const Mesh& mesh, std::span<const Vec3> points,
                                         Executor& executor) {
  const ClosestPoint closest(mesh, executor.threads());
  std::vector<SurfacePoint> places(points.size());
  parallel_for(executor, points.size(), 256, [&](std::size_t i) {
    const FoundPoint found = closest.find(points[i]);
    const auto& [a, b, c] = mesh.triangles[found.triangle];
    const auto [v, w] =
        barycentric_closest_to_origin({mesh.positions[a] - points[i], mesh.positions[b] - points[i],
                                       mesh.positions[c] - points[i]});
    places[i] = {found.triangle, {1 - v - w, v, w}};
  });
  return places;
}

}  // namespace geolloyd
