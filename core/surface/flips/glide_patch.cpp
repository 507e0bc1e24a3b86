#include "core/surface/flips/glide_patch.h"

#include <algorithm>
#include <cstdlib>
#include <unordered_map>

namespace geolloyd {

GlidePatch::GlidePatch(const GlidingRemesh& remesh, VertexId centre, std::size_t rings)
    : remesh_(&remesh), triangles_(0, {}) {
  std::vector<Triangle> triangles;
  add_rings(centre, rings, triangles);
  triangles_ = FlippableTriangles(vertex_.size(), triangles);
  take_vertices();
}

// Ring after ring, so that the last one is the last of the vertices.
void GlidePatch::add_rings(VertexId centre, std::size_t rings, std::vector<Triangle>& triangles) {
  std::unordered_map<VertexId, VertexId> number_of;
  const auto number = [&](VertexId v) {
    const auto [at, is_new] = number_of.emplace(v, static_cast<VertexId>(vertex_.size()));
    if (is_new) vertex_.push_back(v);
    return at->second;
  };
  number(centre);
  std::size_t inner = 0;
  for (std::size_t ring = 0; ring <= rings; ++ring) {
    const std::size_t first = inner;
    inner = vertex_.size();
    for (std::size_t i = first; i < inner; ++i) {
      remesh_->triangles.visit_around(vertex_[i], [&](TriangleId t) {
        const Triangle& corners = remesh_->triangles[t];
        // Of a triangle met before, a corner is one of those whose turn was earlier.
        const bool is_new = std::none_of(corners.begin(), corners.end(), [&](VertexId v) {
          const auto found = number_of.find(v);
          return found != number_of.end() && found->second < i;
        });
        if (!is_new) return;
        triangle_.push_back(t);
        triangles.push_back({number(corners[0]), number(corners[1]), number(corners[2])});
      });
    }
  }
  is_inner_.assign(vertex_.size(), 0);
  std::fill_n(is_inner_.begin(), inner, std::uint8_t{1});
}

void GlidePatch::take_vertices() {
  for (const VertexId v : vertex_) {
    position_.push_back(remesh_->positions[v]);
    area_.push_back(remesh_->fit.area[v]);
    is_inside_.push_back(remesh_->triangles.is_inside(v) ? 1 : 0);
    excess_.push_back(
        is_inside_.back() != 0 ? static_cast<int>(remesh_->triangles.count_around(v)) - 6 : 0);
  }
}

GlidePatch::Region GlidePatch::region_about(std::span<const VertexId> centres,
                                            std::size_t rings) const {
  Region region;
  std::vector<std::uint8_t> has_vertex(vertex_.size(), 0);
  std::vector<std::uint8_t> has_triangle(triangle_.size(), 0);
  const auto add = [&](VertexId v) {
    if (is_inner_[v] == 0 || has_vertex[v] != 0) return;
    has_vertex[v] = 1;
    region.vertices.push_back(v);
  };
  for (const VertexId v : centres) add(v);
  for (std::size_t ring = 0, begin = 0; ring <= rings; ++ring) {
    const std::size_t end = region.vertices.size();
    for (; begin < end; ++begin) {
      triangles_.visit_around(region.vertices[begin], [&](TriangleId t) {
        if (has_triangle[t] == 0) region.triangles.push_back(t);
        has_triangle[t] = 1;
        if (ring == rings) return;
        for (const VertexId v : triangles_[t]) add(v);
      });
    }
  }
  return region;
}

GlidePatch::Region GlidePatch::region_now(const Region& before) const {
  Region now;
  for (const VertexId v : before.vertices) {
    if (triangles_.count_around(v) > 0) now.vertices.push_back(v);
  }
  for (const TriangleId t : before.triangles) {
    if (triangles_.exists(t)) now.triangles.push_back(t);
  }
  for (VertexId v = 0; v < vertex_.size(); ++v) {
    if (vertex_[v] >= remesh_->positions.size()) now.vertices.push_back(v);
  }
  for (TriangleId t = 0; t < triangle_.size(); ++t) {
    if (triangle_[t] >= remesh_->triangles.size()) now.triangles.push_back(t);
  }
  return now;
}

bool GlidePatch::can_flip(FlippableTriangles::Side side) const {
  if (side.triangle == no_id || !triangles_.has_quad(side)) return false;
  const auto [a, b, c, d] = triangles_.quad_of(side);
  for (const VertexId v : {a, b, c, d}) {
    if (is_inner_[v] == 0) return false;
  }
  for (const VertexId v : {b, c}) {
    if (triangles_.count_around(v) <= 3) return false;
  }
  return a != d && !remesh_->is_kept(vertex_[b], vertex_[c]) && !triangles_.is_edge(a, d);
}

void GlidePatch::flip(FlippableTriangles::Side side) {
  const auto [a, b, c, d] = triangles_.quad_of(side);
  triangles_.flip(side);
  for (const VertexId v : {a, d}) excess_[v] += is_inside_[v];
  for (const VertexId v : {b, c}) excess_[v] -= is_inside_[v];
}

// The rings of both have two vertices in common: else the surface would be pinched.
bool GlidePatch::can_collapse(FlippableTriangles::Side side) const {
  if (side.triangle == no_id || !triangles_.has_quad(side)) return false;
  const auto [a, b, c, d] = triangles_.quad_of(side);
  if (!is_free(b) || !is_free(c)) return false;
  for (const VertexId v : {a, d}) {
    if (is_inner_[v] == 0 || !is_inside(v) || triangles_.count_around(v) < 5) return false;
  }
  const std::vector<VertexId> ring = ring_of(b);
  const std::vector<VertexId> other = ring_of(c);
  return std::count_if(ring.begin(), ring.end(), [&](VertexId v) {
           return std::find(other.begin(), other.end(), v) != other.end();
         }) == 2;
}

void GlidePatch::collapse(FlippableTriangles::Side side) {
  const FlippableTriangles::Quad quad = triangles_.quad_of(side);
  std::vector<FlippableTriangles::Replacement> replacements;
  std::array<TriangleId, 2> gone = {side.triangle, triangles_.across(side)};
  triangles_.visit_around(quad.c, [&](TriangleId t) {
    Triangle corners = triangles_[t];
    std::replace(corners.begin(), corners.end(), quad.c, quad.b);
    const bool is_gone = t == gone[0] || t == gone[1];
    replacements.push_back({t, is_gone ? FlippableTriangles::none : corners});
    if (is_gone) return;
    for (const TriangleId from : gone) heirs_.push_back({from, t});
  });
  triangles_.replace(replacements);
  position_[quad.b] = 0.5 * (position_[quad.b] + position_[quad.c]);
  for (const VertexId v : {quad.a, quad.b, quad.c, quad.d}) count_anew(v);
}

// The neighbours of a vertex inside, in their order around it; none where triangles have no common
// orientation.
std::vector<VertexId> GlidePatch::ring_of(VertexId v) const {
  std::vector<VertexId> ring;
  TriangleId t = no_id;
  VertexId next = no_id;
  triangles_.visit_around(v, [&](TriangleId other) { t = std::min(t, other); });
  const std::size_t count = triangles_.count_around(v);
  for (std::size_t i = 0; i < count && t != no_id; ++i) {
    const Triangle& corners = triangles_[t];
    const std::uint32_t k = corners[0] == v ? 0 : (corners[1] == v ? 1 : 2);
    if (i > 0 && triangles_.corner(t, k + 1) != next) return {};
    next = triangles_.corner(t, k + 2);
    ring.push_back(triangles_.corner(t, k + 1));
    t = triangles_.across({t, (k + 1) % 3});
  }
  return ring;
}

std::vector<GlidePatch::Split> GlidePatch::splits_of(VertexId v) const {
  std::vector<Split> splits;
  if (!is_free(v)) return splits;
  const std::vector<VertexId> ring = ring_of(v);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    for (std::size_t j = i + 2; j < ring.size() && j + 2 <= i + ring.size(); ++j) {
      const bool is_here = is_inner_[ring[i]] != 0 && is_inner_[ring[j]] != 0;
      if (is_here) splits.push_back({v, ring[i], ring[j]});
    }
  }
  return splits;
}

// From a to d, both of them with it.
std::vector<VertexId> GlidePatch::arc_of(const Split& split) const {
  std::vector<VertexId> ring = ring_of(split.vertex);
  std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), split.a), ring.end());
  ring.erase(std::find(ring.begin(), ring.end(), split.d) + 1, ring.end());
  return ring;
}

std::array<int, 2> GlidePatch::neighbours_split(const Split& split) const {
  const auto of_new = static_cast<int>(arc_of(split).size()) + 1;
  return {static_cast<int>(triangles_.count_around(split.vertex)) + 4 - of_new, of_new};
}

void GlidePatch::split(const Split& split) {
  constexpr double share = 0.35;  // of the way to the middle of its own neighbours
  const VertexId v = split.vertex;
  const std::vector<VertexId> arc = arc_of(split);
  const auto added = static_cast<VertexId>(vertex_.size());
  std::vector<FlippableTriangles::Replacement> replacements;
  triangles_.visit_around(v, [&](TriangleId t) {
    Triangle corners = triangles_[t];
    const bool is_in_arc = std::all_of(corners.begin(), corners.end(), [&](VertexId corner) {
      return corner == v || std::find(arc.begin(), arc.end(), corner) != arc.end();
    });
    if (!is_in_arc) return;
    std::replace(corners.begin(), corners.end(), v, added);
    replacements.push_back({t, corners});
  });
  const auto next = static_cast<TriangleId>(triangle_.size());
  replacements.push_back({next, {v, split.a, added}});
  replacements.push_back({next + 1, {v, added, split.d}});
  Vec3 middle = Vec3::Zero();
  for (const VertexId w : arc) middle += position_[w] / static_cast<double>(arc.size());
  vertex_.push_back(static_cast<VertexId>(remesh_->positions.size()));
  triangle_.push_back(static_cast<TriangleId>(remesh_->triangles.size()));
  triangle_.push_back(triangle_.back() + 1);
  is_inner_.push_back(1);
  is_inside_.push_back(1);
  excess_.push_back(0);
  area_.push_back(area_[v]);
  const Vec3 place = position_[v] + share * (middle - position_[v]);
  position_.push_back(place);
  triangles_.replace(replacements);
  for (const VertexId w : {v, split.a, split.d, added}) count_anew(w);
}

void GlidePatch::count_anew(VertexId v) {
  const auto count = static_cast<int>(triangles_.count_around(v));
  excess_[v] = is_inside_[v] != 0 && count > 0 ? count - 6 : 0;
}

std::vector<TriangleId> GlidePatch::samples_from(TriangleId t) const {
  std::vector<TriangleId> from;
  if (triangle_[t] < remesh_->triangles.size()) from.push_back(triangle_[t]);
  for (auto heir = heirs_.begin(); heir != heirs_.end(); ++heir) {
    const bool is_first = std::none_of(heirs_.begin(), heir,
                                       [&](const Heir& other) { return other.gone == heir->gone; });
    if (heir->heir == t && is_first) from.push_back(triangle_[heir->gone]);
  }
  return from;
}

bool GlidePatch::is_upright_flipped(FlippableTriangles::Side side) const {
  constexpr double least_area = 0.1;  // of that asked for
  const auto [a, b, c, d] = triangles_.quad_of(side);
  const Vec3 ab = position_[b] - position_[a];
  const Vec3 ac = position_[c] - position_[a];
  const Vec3 ad = position_[d] - position_[a];
  // Of both triangles, and of both flipped ones: the sum of doubled areas is the same.
  const Vec3 normal = normalized(cross(ab, ad) + cross(ad, ac));
  const double least = 2 * least_area * area_[a];
  return dot(cross(ab, ad), normal) > least && dot(cross(ad, ac), normal) > least;
}

std::size_t GlidePatch::count_irregular(const Region& region) const {
  return static_cast<std::size_t>(std::count_if(region.vertices.begin(), region.vertices.end(),
                                                [&](VertexId v) { return excess_[v] != 0; }));
}

int GlidePatch::irregularity(const Region& region) const {
  int sum = 0;
  for (const VertexId v : region.vertices) {
    const int excess = std::abs(excess_[v]);
    sum += excess > 1 ? 3 * excess - 1 : excess;
  }
  return sum;
}

}  // namespace geolloyd
