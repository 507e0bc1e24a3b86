#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/executor.h"
#include "core/mesh/mesh.h"

namespace geolloyd {

/// Two triangles that meet at an edge; ascending.
using TrianglePair = std::array<TriangleId, 2>;

/// A corner is 3 * triangle + position; it stands for the edge opposite to it.
using CornerId = std::uint32_t;

inline TriangleId triangle_of(CornerId corner) {
  return corner / 3;
}

/// The vertex at a corner, and the two ends of the edge opposite to it in the triangle's order.
inline VertexId apex(const Mesh& mesh, CornerId corner) {
  return mesh.triangles[corner / 3][corner % 3];
}
inline VertexId edge_start(const Mesh& mesh, CornerId corner) {
  return mesh.triangles[corner / 3][(corner + 1) % 3];
}
inline VertexId edge_end(const Mesh& mesh, CornerId corner) {
  return mesh.triangles[corner / 3][(corner + 2) % 3];
}

/// The corners of the triangle at the two ends of that edge.
inline CornerId corner_at_start(CornerId corner) {
  return corner % 3 < 2 ? corner + 1 : corner - 2;
}
inline CornerId corner_at_end(CornerId corner) {
  return corner % 3 > 0 ? corner - 1 : corner + 2;
}

/// Calls `visit` with each corner of a triangle, ascending; with none where it names a vertex
/// twice.
template <class Visit>
void for_each_corner(const Mesh& mesh, std::size_t triangle, Visit&& visit) {
  if (!has_three_vertices(mesh.triangles[triangle])) return;
  for (std::uint32_t c = 0; c < 3; ++c) visit(static_cast<CornerId>(3 * triangle + c));
}

/// The undirected edges of a mesh, each once, with the corners (one per incident triangle) opposite
/// to it. Boundary edges have one corner, manifold inner edges two, others are non-manifold.
struct MeshEdges {
  std::vector<std::array<VertexId, 2>> ends;  ///< smaller vertex first; edges in ascending order
  std::vector<std::uint32_t> first_corner;    ///< per edge, and one more
  std::vector<CornerId> corner;               ///< ascending within an edge
  std::vector<TriangleId> duplicates;         ///< with the vertices of an earlier one; ascending

  [[nodiscard]] std::size_t size() const { return ends.size(); }
  [[nodiscard]] std::span<const CornerId> corners(std::size_t edge) const {
    return {corner.data() + first_corner[edge], corner.data() + first_corner[edge + 1]};
  }
};

/// Gives back the memory of all but the duplicates.
inline void release_all_but_duplicates(MeshEdges& edges) {
  edges = {{}, {}, {}, std::move(edges.duplicates)};
}

/// Triangles that name a vertex twice have no edges. O(triangles), but for the sorting of the edges
/// at one vertex.
MeshEdges find_edges(const Mesh& mesh, Executor& executor = sequential());

/// Per vertex, 1 where it is a corner of a triangle with three vertices, else 0.
std::vector<std::uint8_t> referenced_vertices(const Mesh& mesh, Executor& executor = sequential());

/// Positions of these vertices, by id.
std::vector<Vec3> referenced_positions(const Mesh& mesh, Executor& executor = sequential());

}  // namespace geolloyd
