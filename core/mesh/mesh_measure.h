#pragma once

#include <span>
#include <vector>

#include "core/base/buffer.h"
#include "core/base/executor.h"
#include "core/mesh/mesh.h"

namespace geolloyd {

/// Area of a triangle, square mesh units; 0 where it names a vertex twice.
double triangle_area(const Mesh& mesh, const Triangle& triangle);

/// Area of each triangle; 0 for `duplicates`, so that they count once.
Buffer<double> triangle_areas(const Mesh& mesh, std::span<const TriangleId> duplicates,
                              Executor& executor = sequential());

/// A third of the area of the triangles around each vertex, added in their order. Sums to the
/// surface's area.
std::vector<double> vertex_areas(const Mesh& mesh, std::span<const TriangleId> duplicates);

/// What a closed surface encloses, cubic mesh units: positive where triangles are counterclockwise
/// seen from outside.
double enclosed_volume(const Mesh& mesh);

/// How flat a triangle is: its height over its longest edge, divided by that edge. 0.866 where it
/// is equilateral, 0 without area.
double flatness(const Vec3& a, const Vec3& b, const Vec3& c);

/// Mean of the three corners.
Vec3 barycentre(const Mesh& mesh, TriangleId triangle);

}  // namespace geolloyd
