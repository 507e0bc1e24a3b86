#pragma once

// What the readers of mesh files share; not for users of the library.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"
#include "geolloyd/properties.h"

namespace geolloyd {

/// The triangles of a polygon of four and more corners: a fan around its first corner.
struct PolygonFan {
  std::uint32_t first = 0;  ///< id of its first triangle
  std::uint32_t count = 0;
};

/// Replaces the fans of concave polygons, which would cover more than the polygon, by as many
/// triangles that cover the polygon: ears cut off one by one, in order (Meisters 1975). A fan stays
/// where all its triangles face the same way, as in every convex polygon, and where the polygon is
/// not flat, crosses itself so that no ear is left, or has more than 1024 corners or too few ears.
void triangulate_concave(Mesh& mesh, const std::vector<PolygonFan>& fans);

/// Gives each triangle the values of its face: there was one per face before. Few polygons of very
/// many corners could make much of little, so where that would take more than `most_bytes` the
/// properties of the triangles are left out.
void spread_over_triangles(const std::vector<PolygonFan>& fans, std::size_t triangle_count,
                           std::size_t most_bytes, Properties& properties);

}  // namespace geolloyd
