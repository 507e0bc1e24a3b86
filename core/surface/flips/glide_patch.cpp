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
  for (std::size_t ring = 0; ring <= rings; ++ring) {
    const std::size_t first = inner_;
    inner_ = vertex_.size();
    for (std::size_t i = first; i < inner_; ++i) {
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
}

void GlidePatch::take_vertices() {
  for (const VertexId v : vertex_) {
    position_.push_back(remesh_->positions[v]);
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
    if (v >= inner_ || has_vertex[v] != 0) return;
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

bool GlidePatch::can_flip(FlippableTriangles::Side side) const {
  if (side.triangle == no_id || !triangles_.has_quad(side)) return false;
  const auto [a, b, c, d] = triangles_.quad_of(side);
  for (const VertexId v : {a, b, c, d}) {
    if (v >= inner_) return false;
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

bool GlidePatch::is_upright_flipped(FlippableTriangles::Side side) const {
  constexpr double least_area = 0.1;  // of that asked for
  const auto [a, b, c, d] = triangles_.quad_of(side);
  const Vec3 ab = position_[b] - position_[a];
  const Vec3 ac = position_[c] - position_[a];
  const Vec3 ad = position_[d] - position_[a];
  // Of both triangles, and of both flipped ones: the sum of doubled areas is the same.
  const Vec3 normal = normalized(cross(ab, ad) + cross(ad, ac));
  const double least = 2 * least_area * remesh_->fit.area[vertex_[a]];
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
