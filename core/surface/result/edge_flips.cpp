#include "core/surface/result/edge_flips.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/types.h"
#include "core/base/vec3.h"
#include "core/mesh/mesh_measure.h"
#include "core/mesh/mesh_quality.h"

namespace geolloyd {
namespace {

// An edge as one of its triangles sees it: opposite to its corner.
struct Side {
  TriangleId triangle;
  std::uint32_t corner;
};

struct SideOfEdge {
  std::array<VertexId, 2> edge;  // ascending
  Side side;
};

class EdgeFlipper {
 public:
  EdgeFlipper(Mesh& mesh, std::span<const std::array<VertexId, 2>> kept,
              std::span<const Metric> metric)
      : mesh_(mesh),
        kept_(kept),
        metric_(metric),
        across_(mesh.triangles.size(), {no_id, no_id, no_id}) {
    connect();
  }

  std::size_t run() {
    std::size_t flipped = 0;
    const std::size_t most = 10 * mesh_.triangles.size();
    for (TriangleId t = 0; t < across_.size(); ++t) look_at(t);
    for (std::size_t i = 0; i < queue_.size() && flipped < most; ++i) {
      const Side side = queue_[i];
      if (!is_better_flipped(side)) continue;
      flip(side);
      ++flipped;
    }
    return flipped;
  }

 private:
  void connect() {
    std::vector<SideOfEdge> sides;
    for (TriangleId t = 0; t < across_.size(); ++t) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        sides.push_back({ascending(corner(t, k + 1), corner(t, k + 2)), {t, k}});
      }
    }
    std::stable_sort(sides.begin(), sides.end(),
                     [](const SideOfEdge& a, const SideOfEdge& b) { return a.edge < b.edge; });
    for (std::size_t i = 1; i < sides.size(); ++i) {
      if (sides[i - 1].edge != sides[i].edge) continue;
      const auto& [a, b] = std::pair(sides[i - 1].side, sides[i].side);
      across_[a.triangle][a.corner] = b.triangle;
      across_[b.triangle][b.corner] = a.triangle;
    }
  }

  [[nodiscard]] VertexId corner(TriangleId t, std::uint32_t k) const {
    return mesh_.triangles[t][k % 3];
  }
  [[nodiscard]] const Vec3& at(VertexId v) const { return mesh_.positions[v]; }

  void look_at(TriangleId t) {
    for (std::uint32_t k = 0; k < 3; ++k) queue_.push_back({t, k});
  }

  // The corner of `t` across whose opposite edge `other` is.
  [[nodiscard]] std::uint32_t corner_before(TriangleId t, TriangleId other) const {
    const auto found = std::find(across_[t].begin(), across_[t].end(), other);
    return static_cast<std::uint32_t>(found - across_[t].begin());
  }

  // a: the side's corner; b, c: the edge; d: the corner beyond it.
  struct Quad {
    VertexId a, b, c, d;
  };
  // Of two triangles with one orientation.
  [[nodiscard]] bool has_quad(Side side) const {
    const auto& [t, k] = side;
    const TriangleId u = across_[t][k];
    return u != no_id && corner(u, corner_before(u, t) + 1) == corner(t, k + 2);
  }
  [[nodiscard]] Quad quad_of(Side side) const {
    const auto& [t, k] = side;
    const TriangleId u = across_[t][k];
    return {corner(t, k), corner(t, k + 1), corner(t, k + 2), corner(u, corner_before(u, t))};
  }

  [[nodiscard]] bool is_better_flipped(Side side) const {
    if (!has_quad(side)) return false;
    const auto [a, b, c, d] = quad_of(side);
    if (std::binary_search(kept_.begin(), kept_.end(), ascending(b, c))) return false;
    const double now = std::max(largest_cosine(a, b, c), largest_cosine(d, c, b));
    const double flipped = std::max(largest_cosine(a, b, d), largest_cosine(a, d, c));
    return flipped < now && are_flat_flipped(a, b, c, d) && !is_edge(side.triangle, side.corner, d);
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

  // Whether an edge joins a corner of `t` with `v`. Looks around the corner to both sides.
  [[nodiscard]] bool is_edge(TriangleId t, std::uint32_t k, VertexId v) const {
    for (const std::uint32_t turn : {1U, 2U}) {
      TriangleId before = t;
      TriangleId now = across_[t][(k + turn) % 3];
      while (now != no_id && now != t) {
        const std::uint32_t centre = corner_of(now, corner(t, k));
        if (corner(now, centre + 1) == v || corner(now, centre + 2) == v) return true;
        const TriangleId next = across_[now][(centre + 1) % 3];
        const TriangleId other = across_[now][(centre + 2) % 3];
        const TriangleId after = next != before ? next : other;
        before = now;
        now = after;
      }
    }
    return false;
  }
  [[nodiscard]] std::uint32_t corner_of(TriangleId t, VertexId v) const {
    const auto& corners = mesh_.triangles[t];
    return static_cast<std::uint32_t>(std::find(corners.begin(), corners.end(), v) -
                                      corners.begin());
  }

  void flip(Side side) {
    const TriangleId t = side.triangle;
    const TriangleId u = across_[t][side.corner];
    const auto [a, b, c, d] = quad_of(side);
    const std::uint32_t at_d = corner_before(u, t);
    const TriangleId beyond_ab = across_[t][(side.corner + 2) % 3];
    const TriangleId beyond_ca = across_[t][(side.corner + 1) % 3];
    const TriangleId beyond_dc = across_[u][(at_d + 2) % 3];
    const TriangleId beyond_bd = across_[u][(at_d + 1) % 3];
    mesh_.triangles[t] = {a, b, d};
    mesh_.triangles[u] = {a, d, c};
    across_[t] = {beyond_bd, u, beyond_ab};
    across_[u] = {beyond_dc, beyond_ca, t};
    if (beyond_bd != no_id) across_[beyond_bd][corner_before(beyond_bd, u)] = t;
    if (beyond_ca != no_id) across_[beyond_ca][corner_before(beyond_ca, t)] = u;
    look_at(t);
    look_at(u);
  }

  Mesh& mesh_;
  std::span<const std::array<VertexId, 2>> kept_;
  std::span<const Metric> metric_;
  std::vector<std::array<TriangleId, 3>> across_;  // per triangle: beyond the edge opposite to each
                                                   // corner
  std::vector<Side> queue_;
};

}  // namespace

std::size_t flip_edges(Mesh& mesh, std::span<const std::array<VertexId, 2>> kept,
                       std::span<const Metric> metric) {
  return EdgeFlipper(mesh, kept, metric).run();
}

}  // namespace geolloyd
