#pragma once

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/mesh/mesh_edges.h"

namespace geolloyd {

/// What a connected part of a surface is like up to bending: with orientability, all that
/// distinguishes surfaces with boundary (classification of compact surfaces).
struct PartTopology {
  std::int64_t euler_characteristic = 0;
  std::size_t boundary_loops = 0;

  friend bool operator==(const PartTopology&, const PartTopology&) = default;
  friend bool operator<(const PartTopology& a, const PartTopology& b) {
    return std::tie(a.euler_characteristic, a.boundary_loops) <
           std::tie(b.euler_characteristic, b.boundary_loops);
  }
};

struct MeshTopology {
  std::vector<PartTopology> parts;        ///< of vertices connected by edges; ascending
  std::size_t non_manifold_edges = 0;     ///< three and more triangles
  std::size_t non_manifold_vertices = 0;  ///< whose triangles, joined across edges, are not one fan
  std::size_t inconsistent_edges = 0;     ///< two triangles of opposite orientation

  [[nodiscard]] bool is_manifold() const {
    return non_manifold_edges == 0 && non_manifold_vertices == 0;
  }
  /// Of all parts together.
  [[nodiscard]] PartTopology total() const;

  friend bool operator==(const MeshTopology&, const MeshTopology&) = default;
};

/// Of the triangles that have three vertices, and of the vertices they name. O(triangles).
MeshTopology find_topology(const Mesh& mesh, const MeshEdges& edges);

}  // namespace geolloyd
