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

/// In how many pieces long edges of a remesh's surface are to be cut (split_needles.h). Edges of
/// triangles of an ordinary shape have far fewer than twenty for a site, and four for a vertex are
/// as many as are there anyway. So the work is in proportion to what was given and what was asked
/// for.
inline double most_pieces_of_remesh(const Mesh& mesh, std::size_t sites) {
  return static_cast<double>(vertex_limit(mesh, sites));
}

/// For a remesh. Each piece of an edge has some further vertices beside it, and sites have their
/// own (most_vertices_per_site): this is more than any surface has but those whose edges are many,
/// long and no face's, as where each needle is a part of its own. From there on quality suffers,
/// not time.
inline std::size_t vertex_limit_of_remesh(const Mesh& mesh, std::size_t sites) {
  return 100'000 + 64 * sites + 8 * mesh.vertex_count();
}

}  // namespace geolloyd
