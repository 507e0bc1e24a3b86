#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/base/types.h"
#include "core/base/vec3.h"

namespace geolloyd {

/// Three vertices, counter-clockwise seen from outside.
using Triangle = std::array<VertexId, 3>;

/// A triangle soup with shared vertices, in input order. Coordinates are finite and indices in
/// range; nothing else is promised (see mesh_check.h).
struct Mesh {
  std::vector<Vec3> positions;  ///< mesh units
  std::vector<Triangle> triangles;

  [[nodiscard]] std::size_t vertex_count() const { return positions.size(); }
  [[nodiscard]] std::size_t triangle_count() const { return triangles.size(); }
};

/// Most vertices of a mesh: every id but the one that stands for "none".
inline constexpr std::size_t most_vertices = no_id;
/// Most triangles: each of their corners has such an id too (mesh_edges.h).
inline constexpr std::size_t most_triangles = no_id / 3;

constexpr bool ids_suffice(Uint128 vertices, Uint128 triangles) {
  return vertices <= most_vertices && triangles <= most_triangles;
}

/// False where a triangle names a vertex twice. Such a triangle is kept, so that ids stay those of
/// the input, but it takes part in nothing.
inline bool has_three_vertices(const Triangle& t) {
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

}  // namespace geolloyd
