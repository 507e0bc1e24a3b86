#include "core/mesh/quad_pairs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/base/vec3.h"

namespace geolloyd {
namespace {

constexpr double widest_cosine = 0.8660254037844386;  // of corners from 30 to 150 degrees
constexpr double least_flatness = 0.5;                // cosine of the bend

class Pairing {
 public:
  Pairing(const Mesh& mesh, const MeshEdges& edges)
      : mesh_(mesh),
        edges_(edges),
        partner_edge_(mesh.triangle_count(), no_id),
        edge_of_(3 * mesh.triangle_count(), no_id),
        cost_(edges.size(), refused),
        spare_(mesh.vertex_count(), -least_edges) {
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      const auto corners = edges.corners(e);
      for (const CornerId corner : corners) edge_of_[corner] = e;
      for (const VertexId v : edges.ends[e]) spare_[v] += corners.size() == 2 ? 1 : least_edges;
      cost_[e] = cost_of(e);
    }
    pair_best_first();
    pair_over_pairs();
  }

  [[nodiscard]] QuadPairs result() const {
    QuadPairs found;
    found.is_inner.assign(3 * mesh_.triangle_count(), 0);
    double least_cosine = 1;
    double most_cosine = -1;
    for (TriangleId t = 0; t < mesh_.triangle_count(); ++t) {
      const std::uint32_t e = partner_edge_[t];
      if (e == no_id) {
        const auto& [a, b, c] = mesh_.triangles[t];
        found.faces.push_back({{a, b, c, no_id}, t});
      } else if (t == std::min(sides(e)[0], sides(e)[1])) {
        const std::array<VertexId, 4> corners = quad(e);
        found.faces.push_back({corners, t});
        ++found.quads;
        for (const CornerId corner : edges_.corners(e)) found.is_inner[corner] = 1;
        for (std::size_t i = 0; i < corners.size(); ++i) {
          least_cosine = std::min(least_cosine, corner_cosine(corners, i));
          most_cosine = std::max(most_cosine, corner_cosine(corners, i));
        }
      }
    }
    if (found.quads > 0) {
      constexpr double degrees = 180 / std::numbers::pi;
      found.smallest_angle = std::acos(most_cosine) * degrees;
      found.largest_angle = std::acos(least_cosine) * degrees;
    }
    return found;
  }

 private:
  static constexpr double refused = 2;
  static constexpr std::int64_t least_edges = 3;

  [[nodiscard]] std::array<TriangleId, 2> sides(std::uint32_t edge) const {
    const auto corners = edges_.corners(edge);
    return {triangle_of(corners[0]), triangle_of(corners[1])};
  }

  [[nodiscard]] std::array<VertexId, 4> quad(std::uint32_t edge) const {
    const auto corners = edges_.corners(edge);
    return {apex(mesh_, corners[0]), edge_start(mesh_, corners[0]), apex(mesh_, corners[1]),
            edge_end(mesh_, corners[0])};
  }

  [[nodiscard]] double corner_cosine(const std::array<VertexId, 4>& q, std::size_t i) const {
    const Vec3& place = mesh_.positions[q[i]];
    return dot(normalized(mesh_.positions[q[(i + 1) % 4]] - place),
               normalized(mesh_.positions[q[(i + 3) % 4]] - place));
  }

  [[nodiscard]] Vec3 triangle_normal(TriangleId t) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    const std::vector<Vec3>& p = mesh_.positions;
    return normalized(cross(p[b] - p[a], p[c] - p[a]));
  }

  // The largest cosine of a corner, up to sign; `refused` where the edge makes no quadrilateral.
  [[nodiscard]] double cost_of(std::uint32_t edge) const {
    const auto corners = edges_.corners(edge);
    if (corners.size() != 2 || edge_start(mesh_, corners[0]) == edge_start(mesh_, corners[1])) {
      return refused;
    }
    const std::array<VertexId, 4> q = quad(edge);
    if (q[0] == q[2]) return refused;
    const auto place = [&](std::size_t i) -> const Vec3& { return mesh_.positions[q[i % 4]]; };
    const auto [first, second] = sides(edge);
    if (!(dot(triangle_normal(first), triangle_normal(second)) >= least_flatness)) return refused;
    const Vec3 normal = cross(place(2) - place(0), place(3) - place(1));
    double worst = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 turn = cross(place(i + 1) - place(i), place(i + 3) - place(i));
      if (!(dot(turn, normal) > 0)) return refused;
      worst = std::max(worst, std::abs(corner_cosine(q, i)));
    }
    return worst <= widest_cosine ? worst : refused;
  }

  [[nodiscard]] bool may_pair(std::uint32_t edge) const {
    const auto& [a, b] = edges_.ends[edge];
    return cost_[edge] < refused && spare_[a] > 0 && spare_[b] > 0;
  }

  void pair(std::uint32_t edge) {
    for (const TriangleId t : sides(edge)) partner_edge_[t] = edge;
    for (const VertexId v : edges_.ends[edge]) --spare_[v];
  }

  void part(std::uint32_t edge) {
    for (const TriangleId t : sides(edge)) partner_edge_[t] = no_id;
    for (const VertexId v : edges_.ends[edge]) ++spare_[v];
  }

  [[nodiscard]] bool is_free(TriangleId t) const { return partner_edge_[t] == no_id; }

  void pair_best_first() {
    std::vector<std::uint32_t> order;
    order.reserve(edges_.size());
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      if (cost_[e] < refused) order.push_back(e);
    }
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return cost_[a] != cost_[b] ? cost_[a] < cost_[b] : a < b;
    });
    for (const std::uint32_t e : order) {
      if (is_free(sides(e)[0]) && is_free(sides(e)[1]) && may_pair(e)) pair(e);
    }
  }

  [[nodiscard]] TriangleId beyond(std::uint32_t edge, TriangleId t) const {
    const auto [first, second] = sides(edge);
    return first == t ? second : first;
  }

  // Edges of `t` that make a quadrilateral.
  [[nodiscard]] std::vector<std::uint32_t> ways_from(TriangleId t) const {
    std::vector<std::uint32_t> ways;
    for (CornerId corner = 3 * t; corner < 3 * t + 3; ++corner) {
      if (edge_of_[corner] != no_id && cost_[edge_of_[corner]] < refused) {
        ways.push_back(edge_of_[corner]);
      }
    }
    return ways;
  }

  // The pair next to `t` parts, and its other triangle goes with another free one.
  bool pair_over_pair(TriangleId t) {
    for (const std::uint32_t near : ways_from(t)) {
      const TriangleId next = beyond(near, t);
      if (is_free(next)) continue;
      const std::uint32_t between = partner_edge_[next];
      const TriangleId other = beyond(between, next);
      for (const std::uint32_t far : ways_from(other)) {
        const TriangleId end = beyond(far, other);
        if (end == t || !is_free(end)) continue;
        part(between);
        if (may_pair(near)) {
          pair(near);
          if (may_pair(far)) {
            pair(far);
            return true;
          }
          part(near);
        }
        pair(between);
      }
    }
    return false;
  }

  void pair_over_pairs() {
    for (bool has_changed = true; has_changed;) {
      has_changed = false;
      for (TriangleId t = 0; t < mesh_.triangle_count(); ++t) {
        if (is_free(t) && pair_over_pair(t)) has_changed = true;
      }
    }
  }

  const Mesh& mesh_;
  const MeshEdges& edges_;
  std::vector<std::uint32_t> partner_edge_;  // per triangle
  std::vector<std::uint32_t> edge_of_;       // per corner
  std::vector<double> cost_;                 // per edge
  std::vector<std::int64_t> spare_;          // per vertex: edges that may go
};

}  // namespace

QuadPairs pair_triangles(const Mesh& mesh, const MeshEdges& edges) {
  return Pairing(mesh, edges).result();
}

}  // namespace geolloyd
