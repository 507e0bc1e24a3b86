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

/// Leaves out triangles, and keeps the others in order.
void remove_triangles(MeshUnderRepair& state, const std::vector<std::uint8_t>& is_removed);

/// Leaves out the vertices of no triangle, and keeps the others in order.
void remove_unused_vertices(MeshUnderRepair& state);

}  // namespace geolloyd
