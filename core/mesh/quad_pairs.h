#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/mesh/mesh_edges.h"

namespace geolloyd {

/// A triangle, or a quadrilateral made of two.
struct Face {
  std::array<VertexId, 4> corners;  ///< in the order of the surface; the last is no_id: a triangle
  TriangleId triangle;              ///< that it is, or the first of both

  [[nodiscard]] bool is_quad() const { return corners[3] != no_id; }
};

/// The faces of a quad-dominant mesh: all triangles, many of them in pairs.
struct QuadPairs {
  std::vector<Face> faces;             ///< by triangle, ascending
  std::vector<std::uint8_t> is_inner;  ///< per corner: a quadrilateral hides the edge opposite
  std::size_t quads = 0;
  double smallest_angle = 0;  ///< of a corner of a quadrilateral, degrees; 0 without one
  double largest_angle = 0;
};

/// Pairs triangles over edges that two of them share with one orientation. A quadrilateral is
/// convex seen along the normal of its diagonals, has corners of 30 to 150 degrees, and bends by 60
/// degrees at most. Vertices off the boundary keep three edges. First the pairs whose worst corner
/// is nearest to a right angle, ties to the smaller edge. Then two unpaired triangles with a pair
/// between them become two pairs, while there are any. O(triangles log triangles).
QuadPairs pair_triangles(const Mesh& mesh, const MeshEdges& edges);

}  // namespace geolloyd
