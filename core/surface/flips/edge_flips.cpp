#include "core/surface/flips/edge_flips.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/base/types.h"
#include "core/base/vec3.h"
#include "core/mesh/mesh_measure.h"
#include "core/mesh/mesh_quality.h"
#include "core/surface/flips/flippable_triangles.h"

namespace geolloyd {
namespace {

using Side = FlippableTriangles::Side;

class EdgeFlipper {
 public:
  EdgeFlipper(const Mesh& mesh, std::span<const std::array<VertexId, 2>> kept,
              std::span<const Metric> metric)
      : mesh_(mesh),
        kept_(kept),
        metric_(metric),
        triangles_(mesh.vertex_count(), mesh.triangles) {}

  std::size_t run() {
    std::size_t flipped = 0;
    const std::size_t most = 10 * triangles_.size();
    for (TriangleId t = 0; t < triangles_.size(); ++t) look_at(t);
    for (std::size_t i = 0; i < queue_.size() && flipped < most; ++i) {
      const Side side = queue_[i];
      if (!is_better_flipped(side)) continue;
      const TriangleId other = triangles_.across(side);
      triangles_.flip(side);
      look_at(side.triangle);
      look_at(other);
      ++flipped;
    }
    return flipped;
  }

  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_.triangles(); }

 private:
  [[nodiscard]] const Vec3& at(VertexId v) const { return mesh_.positions[v]; }

  void look_at(TriangleId t) {
    for (std::uint32_t k = 0; k < 3; ++k) queue_.push_back({t, k});
  }

  [[nodiscard]] bool is_better_flipped(Side side) const {
    if (!triangles_.has_quad(side)) return false;
    const auto [a, b, c, d] = triangles_.quad_of(side);
    if (std::binary_search(kept_.begin(), kept_.end(), ascending(b, c))) return false;
    const double now = std::max(largest_cosine(a, b, c), largest_cosine(d, c, b));
    const double flipped = std::max(largest_cosine(a, b, d), largest_cosine(a, d, c));
    return flipped < now && are_flat_flipped(a, b, c, d) && !triangles_.is_edge(a, d);
  }

  // A triangle without area has no normal but that of the other one.
  [[nodiscard]] bool are_flat_flipped(VertexId a, VertexId b, VertexId c, VertexId d) const {
    const Vec3 here = has_area(a, b, c) ? normal(a, b, c) : normal(d, c, b);
    const Vec3 there = has_area(d, c, b) ? normal(d, c, b) : here;
    return is_flat(here, there) && is_flat(normal(a, b, d), normal(a, d, c)) &&
           is_flat(here, normal(a, b, d));
  }
  [[nodiscard]] bool has_area(VertexId a, VertexId b, VertexId c) const {
    constexpr double least = 1e-6;  // height over the longest edge
    return flatness(at(a), at(b), at(c)) > least;
  }

  // Of the triangle's angles: that of the smallest.
  [[nodiscard]] double largest_cosine(VertexId a, VertexId b, VertexId c) const {
    return cosine_of_smallest_angle(corners_of(mesh_, {a, b, c}, metric_));
  }

  [[nodiscard]] Vec3 normal(VertexId a, VertexId b, VertexId c) const {
    return normalized(cross(at(b) - at(a), at(c) - at(a)));
  }
  static bool is_flat(const Vec3& m, const Vec3& n) {
    constexpr double least_cosine = 0.8660254037844386;  // of 30 degrees
    return dot(m, n) > least_cosine;
  }

  const Mesh& mesh_;
  std::span<const std::array<VertexId, 2>> kept_;
  std::span<const Metric> metric_;
  FlippableTriangles triangles_;
  std::vector<Side> queue_;
};

}  // namespace

std::size_t flip_edges(Mesh& mesh, std::span<const std::array<VertexId, 2>> kept,
                       std::span<const Metric> metric) {
  EdgeFlipper flipper(mesh, kept, metric);
  const std::size_t flipped = flipper.run();
  mesh.triangles = flipper.triangles();
  return flipped;
}

}  // namespace geolloyd
