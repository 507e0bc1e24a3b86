#include "core/surface/flips/flippable_triangles.h"

#include <algorithm>
#include <utility>

namespace geolloyd {

FlippableTriangles::FlippableTriangles(std::size_t vertices, std::span<const Triangle> triangles)
    : triangles_(triangles.begin(), triangles.end()),
      across_(triangles.size(), {no_id, no_id, no_id}),
      one_at_(vertices, no_id) {
  std::vector<SideOfEdge> sides;
  sides.reserve(3 * size());
  for (TriangleId t = 0; t < size(); ++t) {
    add_sides(t, sides);
    for (const VertexId v : triangles_[t]) one_at_[v] = t;
  }
  connect(std::move(sides));
}

void FlippableTriangles::add_sides(TriangleId t, std::vector<SideOfEdge>& sides) const {
  for (std::uint32_t k = 0; k < 3; ++k) {
    sides.push_back({ascending(corner(t, k + 1), corner(t, k + 2)), {t, k}});
  }
}

void FlippableTriangles::connect(std::vector<SideOfEdge> sides) {
  std::stable_sort(sides.begin(), sides.end(),
                   [](const SideOfEdge& a, const SideOfEdge& b) { return a.edge < b.edge; });
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (sides[i - 1].edge != sides[i].edge) continue;
    const Side& a = sides[i - 1].side;
    const Side& b = sides[i].side;
    across_[a.triangle][a.corner] = b.triangle;
    across_[b.triangle][b.corner] = a.triangle;
  }
}

std::size_t FlippableTriangles::count_around(VertexId v) const {
  std::size_t count = 0;
  visit_around(v, [&](TriangleId) { ++count; });
  return count;
}

bool FlippableTriangles::is_inside(VertexId v) const {
  bool is_inside = one_at_[v] != no_id;
  visit_around(v, [&](TriangleId t) {
    const std::uint32_t k = corner_of(t, v);
    is_inside = is_inside && across_[t][(k + 1) % 3] != no_id && across_[t][(k + 2) % 3] != no_id;
  });
  return is_inside;
}

bool FlippableTriangles::is_edge(VertexId a, VertexId b) const {
  return side_of(a, b).triangle != no_id;
}

FlippableTriangles::Side FlippableTriangles::side_of(VertexId b, VertexId c) const {
  Side found;
  visit_around(b, [&](TriangleId t) {
    const std::uint32_t k = corner_of(t, b);
    if (found.triangle != no_id) return;
    if (corner(t, k + 1) == c) found = {t, (k + 2) % 3};
    if (corner(t, k + 2) == c) found = {t, (k + 1) % 3};
  });
  return found;
}

bool FlippableTriangles::has_quad(Side side) const {
  const auto& [t, k] = side;
  const TriangleId u = across_[t][k];
  return u != no_id && corner(u, corner_before(u, t) + 1) == corner(t, k + 2);
}

FlippableTriangles::Quad FlippableTriangles::quad_of(Side side) const {
  const auto& [t, k] = side;
  const TriangleId u = across_[t][k];
  return {corner(t, k), corner(t, k + 1), corner(t, k + 2), corner(u, corner_before(u, t))};
}

void FlippableTriangles::flip(Side side) {
  const TriangleId t = side.triangle;
  const TriangleId u = across_[t][side.corner];
  const auto [a, b, c, d] = quad_of(side);
  const std::uint32_t at_d = corner_before(u, t);
  const TriangleId beyond_ab = across_[t][(side.corner + 2) % 3];
  const TriangleId beyond_ca = across_[t][(side.corner + 1) % 3];
  const TriangleId beyond_dc = across_[u][(at_d + 2) % 3];
  const TriangleId beyond_bd = across_[u][(at_d + 1) % 3];
  triangles_[t] = {a, b, d};
  triangles_[u] = {a, d, c};
  across_[t] = {beyond_bd, u, beyond_ab};
  across_[u] = {beyond_dc, beyond_ca, t};
  if (beyond_bd != no_id) across_[beyond_bd][corner_before(beyond_bd, u)] = t;
  if (beyond_ca != no_id) across_[beyond_ca][corner_before(beyond_ca, t)] = u;
  one_at_[a] = t;
  one_at_[b] = t;
  one_at_[d] = u;
  one_at_[c] = u;
}

// Sides of triangles about the place are found again as those of edges they have in common with it.
void FlippableTriangles::replace(std::span<const Replacement> replacements) {
  std::vector<TriangleId> about;
  for (const Replacement& replacement : replacements) {
    make_room(replacement);
    const TriangleId t = replacement.triangle;
    for (const VertexId v : triangles_[t]) {
      if (v != no_id) one_at_[v] = no_id;
    }
    about.insert(about.end(), across_[t].begin(), across_[t].end());
  }
  for (const auto& [t, corners] : replacements) {
    triangles_[t] = corners;
    across_[t] = {no_id, no_id, no_id};
    about.push_back(t);
  }
  std::sort(about.begin(), about.end());
  about.erase(std::unique(about.begin(), about.end()), about.end());
  std::vector<SideOfEdge> sides;
  for (const TriangleId t : about) {
    if (t == no_id || !exists(t)) continue;
    add_sides(t, sides);
    for (const VertexId v : triangles_[t]) one_at_[v] = t;
  }
  connect(std::move(sides));
}

void FlippableTriangles::make_room(const Replacement& replacement) {
  if (replacement.triangle >= triangles_.size()) {
    triangles_.resize(replacement.triangle + 1, none);
    across_.resize(triangles_.size(), {no_id, no_id, no_id});
  }
  for (const VertexId v : replacement.corners) {
    if (v != no_id && v >= one_at_.size()) one_at_.resize(v + 1, no_id);
  }
}

}  // namespace geolloyd
