#pragma once

#include <span>
#include <vector>

#include "core/base/grouping.h"
#include "core/mesh/mesh.h"

namespace geolloyd {

/// Area of a triangle, square mesh units; 0 where it names a vertex twice.
double triangle_area(const Mesh& mesh, const Triangle& triangle);

/// Area of each triangle; 0 for `duplicates`, so that they count once.
template <class Executor>
Buffer<double> triangle_areas_on(Executor& executor, const Mesh& mesh,
                                 std::span<const TriangleId> duplicates) {
  Buffer<double> areas(mesh.triangle_count());
  for_items(executor, areas.size(), small_items,
            [&](std::size_t t) { areas[t] = triangle_area(mesh, mesh.triangles[t]); });
  for (const TriangleId t : duplicates) areas[t] = 0;
  return areas;
}
Buffer<double> triangle_areas(const Mesh& mesh, std::span<const TriangleId> duplicates);

/// A third of the area of the triangles around each vertex, added in their order. Sums to the
/// surface's area.
std::vector<double> vertex_areas(const Mesh& mesh, std::span<const double> triangle_area);

/// Mean of the three corners.
Vec3 barycentre(const Mesh& mesh, TriangleId triangle);

}  // namespace geolloyd
