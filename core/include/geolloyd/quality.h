#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

#include "geolloyd/mesh.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

/// Angles, quality of triangles (Frey and Borouchaki 1999) and valences of a mesh, which may have
/// no triangles. O(triangles). Throws InvalidInput where the mesh is not valid.
struct MeshQuality quality(const Mesh& mesh);

/// Connected parts and flaws of a mesh, which may have no triangles: of the triangles that have
/// three vertices, and of the vertices they name. O(triangles). Throws InvalidInput where the mesh
/// is not valid.
struct MeshTopology find_topology(const Mesh& mesh);

/// The pairs of triangles that have a point in common beside the corners, or the edge, that they
/// share; ascending. Corners in the very same place are shared, triangles without area are left
/// out, and what merely touches counts. Exact where coordinates are 0 or have a magnitude from
/// 1e-75 on. Throws InvalidInput where the mesh is not valid.
std::vector<std::array<TriangleId, 2>> self_intersections(const Mesh& mesh,
                                                          Runtime& runtime = all_threads());

/// The figures by which remeshes are compared. Every triangle of the mesh counts, degenerate and
/// duplicate ones as well. A vertex is inner where each of its edges, at least one, has exactly two
/// triangles; its valence is the number of these edges. Without triangles, or without inner
/// vertices, what is a mean or a share of them is not a number.
struct MeshQuality {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  double smallest_angle = none;       ///< of all triangles, degrees
  double mean_smallest_angle = none;  ///< mean of each triangle's smallest one, degrees
  double share_under_30 = none;       ///< of triangles whose smallest angle is under 30 degrees
  double share_obtuse =
      none;  ///< of triangles with an angle over 90 degrees, not by rounding alone
  double smallest_quality = none;
  double mean_quality = none;
  std::size_t inner_vertices = 0;
  double share_valence_6 = none;       ///< of inner vertices
  double share_valence_5_to_7 = none;  ///< of inner vertices
};

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

}  // namespace geolloyd
