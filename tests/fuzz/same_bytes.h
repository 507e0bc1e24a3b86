#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <tuple>
#include <vector>

#include "core/dual_mesh.h"
#include "core/mesh_check.h"
#include "core/mesh_graph.h"

/// Whether two twins made the same, to the last bit.
namespace geolloyd::fuzz {

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}
inline bool same_bytes(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

inline bool same_bytes(const MeshEdges& a, const MeshEdges& b) {
  return same_bytes(a.ends, b.ends) && same_bytes(a.first_corner, b.first_corner) &&
         same_bytes(a.corner, b.corner) && same_bytes(a.duplicates, b.duplicates);
}

inline bool same_bytes(const MeshFacts& a, const MeshFacts& b) {
  const auto counts = [](const MeshFacts& f) {
    return std::tie(f.vertices, f.edges, f.triangles, f.unreferenced_vertices,
                    f.repeated_vertex_triangles, f.zero_area_triangles, f.duplicate_triangles,
                    f.boundary_edges, f.non_manifold_edges, f.inconsistent_edges,
                    f.zero_length_edges, f.components, f.euler_characteristic);
  };
  return counts(a) == counts(b) && same_bytes(a.area, b.area) &&
         same_bytes(a.bounding_diagonal, b.bounding_diagonal);
}

inline bool same_bytes(const Graph& a, const Graph& b) {
  return same_bytes(a.first_arc, b.first_arc) && same_bytes(a.target, b.target) &&
         same_bytes(a.length, b.length) && same_bytes(a.mass, b.mass) &&
         same_bytes(a.tick_length, b.tick_length) && same_bytes(a.tick_mass, b.tick_mass);
}

inline bool same_bytes(const MeshGraph& a, const MeshGraph& b) {
  return a.kind == b.kind && a.first_triangle_id == b.first_triangle_id &&
         same_bytes(a.input_id, b.input_id) && same_bytes(a.node_of, b.node_of) &&
         same_bytes(a.position, b.position) && same_bytes(a.graph, b.graph);
}

inline bool same_bytes(const DualMesh& a, const DualMesh& b) {
  const auto same_obstacles = [&] {
    for (std::size_t i = 0; i < a.obstacles.size(); ++i) {
      if (a.obstacles[i].kind != b.obstacles[i].kind ||
          a.obstacles[i].regions != b.obstacles[i].regions) {
        return false;
      }
    }
    return true;
  };
  return same_bytes(a.triangles, b.triangles) && same_bytes(a.corner, b.corner) &&
         a.repeated == b.repeated && a.folded == b.folded &&
         a.obstacles.size() == b.obstacles.size() && same_obstacles();
}

}  // namespace geolloyd::fuzz
