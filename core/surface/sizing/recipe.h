#pragma once

#include <cmath>
#include <cstddef>

#include "core/surface/sizing/sizing.h"

namespace geolloyd {

// How finely the surface is cut on which sites move: so that each cell has vertices, by whose
// labels it finds its neighbours.

/// The longest edge over the side of a cell, the root of its area.
inline constexpr double edge_per_side = 0.6;
/// The longest edge over the spacing of sites where there are features, so that cells follow them.
inline constexpr double edge_per_spacing_at_features = 0.42;
/// Vertices that a cell has then, where cells are alike and where their sizes or shapes vary.
inline constexpr std::size_t vertices_per_site = 10;
inline constexpr std::size_t most_vertices_per_site = 24;

/// How fast sizes grow from small features: faster than wanted sizes, for there may be many.
inline constexpr double growth_at_small_features = 1.3;

inline double longest_edge(double area, std::size_t sites) {
  return edge_per_side * std::sqrt(area / static_cast<double>(sites));
}

inline double longest_edge_at_features(double area, std::size_t sites) {
  return edge_per_spacing_at_features * spacing_of(area, static_cast<double>(sites));
}

/// No surface has more vertices than this: needles would be cut again and again.
inline std::size_t vertex_limit(const Mesh& mesh, std::size_t sites) {
  return 20 * sites + 4 * mesh.vertex_count();
}

/// For a remesh, where a small mesh of needles may take as many as do no harm.
inline std::size_t vertex_limit_of_remesh(const Mesh& mesh, std::size_t sites) {
  return 1'000'000 + vertex_limit(mesh, sites);
}

}  // namespace geolloyd
