#pragma once

#include <cstdint>
#include <vector>

#include "core/base/executor.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_edges.h"

namespace geolloyd {

/// A mesh between two steps of a repair. Vertices of no triangle may remain until the end.
struct MeshUnderRepair {
  Mesh mesh;
  std::vector<VertexId> vertex_origin;      ///< per vertex: that of the input
  std::vector<TriangleId> triangle_origin;  ///< per triangle: that of the input, or no_id
};

/// Below this share of its longest edge, the height of a triangle is none (flatness,
/// mesh_measure.h).
inline constexpr double sliver_flatness = 1e-6;

bool is_sliver(const Mesh& mesh, const Triangle& triangle);

/// Per vertex the smallest vertex in the very same place. O(n log n).
std::vector<VertexId> places_of(const Mesh& mesh);

/// Per vertex the smallest vertex that it is connected to by edges.
std::vector<VertexId> components_of(const Mesh& mesh);

/// Leaves out triangles, and keeps the others in order.
void remove_triangles(MeshUnderRepair& state, const std::vector<std::uint8_t>& is_removed);

/// Renames vertices in all triangles.
void rename_vertices(Mesh& mesh, const std::vector<VertexId>& name);

/// Leaves out the vertices of no triangle, and keeps the others in order.
void remove_unused_vertices(MeshUnderRepair& state);

}  // namespace geolloyd
