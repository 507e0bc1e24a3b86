#pragma once

#include <cstddef>

#include "core/base/types.h"
#include "core/base/vec3.h"
#include "geolloyd/mesh.h"

namespace geolloyd {

/// Most vertices of a mesh: every id but the one that stands for "none".
inline constexpr std::size_t most_vertices = no_id;
/// Most triangles: each of their corners has such an id too (mesh_edges.h).
inline constexpr std::size_t most_triangles = no_id / 3;

constexpr bool ids_suffice(Uint128 vertices, Uint128 triangles) {
  return vertices <= most_vertices && triangles <= most_triangles;
}

/// The same as validate(), for a mesh that may have no triangles.
void validate_contents(const Mesh& mesh);

/// False where a triangle names a vertex twice. Such a triangle is kept, so that ids stay those of
/// the input, but it takes part in nothing.
inline bool has_three_vertices(const Triangle& t) {
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

}  // namespace geolloyd
