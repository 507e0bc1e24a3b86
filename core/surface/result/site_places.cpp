#include "core/surface/result/site_places.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "core/base/bucketing.h"
#include "core/mesh/closest_on_triangle.h"
#include "core/mesh/mesh_edges.h"

namespace geolloyd {
namespace {

// The point of a triangle that is closest to `p`.
std::array<double, 3> closest_barycentric(const Vec3& p, const Vec3& a, const Vec3& b,
                                          const Vec3& c) {
  const auto [v, w] = barycentric_closest_to_origin({a - p, b - p, c - p});
  const double u = 1 - v - w;
  return {u > 0 ? u : 0, v, w};
}

// Where edges of the surface were flipped, a triangle of the mesh is near what it is the origin of.
// From there the search goes from triangle to triangle, always on from the closest one met.
class NearbySearch {
 public:
  explicit NearbySearch(const Mesh& mesh)
      : mesh_(mesh), across_(mesh.triangle_count(), {no_id, no_id, no_id}) {
    const MeshEdges edges = find_edges(mesh);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const std::span<const CornerId> corners = edges.corners(e);
      if (corners.size() != 2) continue;
      across_[corners[0] / 3][corners[0] % 3] = triangle_of(corners[1]);
      across_[corners[1] / 3][corners[1] % 3] = triangle_of(corners[0]);
    }
  }

  /// `starts`: some.
  [[nodiscard]] TriangleId closest(const std::set<TriangleId>& starts, const Vec3& p) const {
    constexpr int most_in_vain = 32;
    constexpr int most = 1 << 14;
    std::set<std::pair<double, TriangleId>> open;
    for (const TriangleId t : starts) open.emplace(square_distance(t, p), t);
    std::set<TriangleId> met = starts;
    auto best = *open.begin();
    for (int step = 0, in_vain = 0; !open.empty() && step < most && in_vain < most_in_vain;
         ++step, ++in_vain) {
      const auto nearest = *open.begin();
      open.erase(open.begin());
      if (nearest < best) {
        best = nearest;
        in_vain = 0;
      }
      for (const TriangleId t : across_[nearest.second]) {
        if (t != no_id && met.insert(t).second) open.emplace(square_distance(t, p), t);
      }
    }
    return best.second;
  }

 private:
  [[nodiscard]] double square_distance(TriangleId t, const Vec3& p) const {
    const auto& [ia, ib, ic] = mesh_.triangles[t];
    const Vec3& a = mesh_.positions[ia];
    const Vec3& b = mesh_.positions[ib];
    const Vec3& c = mesh_.positions[ic];
    const auto [x, y, z] = closest_barycentric(p, a, b, c);
    const Vec3 away = x * a + y * b + z * c - p;
    return dot(away, away);
  }

  const Mesh& mesh_;
  std::vector<std::array<TriangleId, 3>> across_;
};

class SitePlacer {
 public:
  SitePlacer(const Mesh& mesh, const SurfaceInput& input) : mesh_(mesh), input_(input) {
    if (input.has_flips) nearby_.emplace(mesh);
  }

  [[nodiscard]] SurfacePoint find(const Vec3& site, std::span<const VertexId> cell) const {
    const VertexId nearest = nearest_of(cell, {}, site, no_id);
    return nearest == no_id ? SurfacePoint{} : closest_about(nearest, site);
  }

  // From the cell downhill, over no vertex that is marked.
  [[nodiscard]] SurfacePoint find_beyond(const Vec3& site, std::span<const VertexId> cell,
                                         std::span<const std::uint8_t> is_marked) const {
    VertexId nearest = nearest_of(cell, {}, site, no_id);
    if (nearest == no_id) return {};
    for (VertexId from = no_id; from != nearest;) {
      from = nearest;
      nearest = nearest_of(input_.fine.neighbours(from), is_marked, site, from);
    }
    return closest_about(nearest, site);
  }

 private:
  // Of those that are not marked, and of `else_this`, if that is a vertex.
  [[nodiscard]] VertexId nearest_of(std::span<const VertexId> vertices,
                                    std::span<const std::uint8_t> is_marked, const Vec3& site,
                                    VertexId else_this) const {
    const auto square_distance = [&](VertexId v) {
      const Vec3 away = input_.fine.positions[v] - site;
      return dot(away, away);
    };
    VertexId nearest = else_this;
    double least =
        else_this == no_id ? std::numeric_limits<double>::infinity() : square_distance(else_this);
    for (const VertexId v : vertices) {
      if (!is_marked.empty() && is_marked[v] != 0) continue;
      const double square = square_distance(v);
      if (!(square < least)) continue;
      least = square;
      nearest = v;
    }
    return nearest;
  }

  // On the triangles at a vertex and at its neighbours.
  [[nodiscard]] SurfacePoint closest_about(VertexId centre, const Vec3& site) const {
    Closest best{std::numeric_limits<double>::infinity(), no_id, site};
    offer_triangles_at(centre, site, best);
    for (const VertexId v : input_.fine.neighbours(centre)) offer_triangles_at(v, site, best);
    const Vec3 point = input_.frame.to_mesh(best.point);
    TriangleId origin = input_.origin[best.triangle];
    if (nearby_) origin = nearby_->closest(origins_about(centre), point);
    const auto& [a, b, c] = mesh_.triangles[origin];
    return {origin,
            closest_barycentric(point, mesh_.positions[a], mesh_.positions[b], mesh_.positions[c])};
  }

  [[nodiscard]] std::set<TriangleId> origins_about(VertexId centre) const {
    std::set<TriangleId> origins;
    const auto add_at = [&](VertexId v) {
      for (const TriangleId t : input_.fine.triangles_at(v)) origins.insert(input_.origin[t]);
    };
    add_at(centre);
    for (const VertexId v : input_.fine.neighbours(centre)) add_at(v);
    return origins;
  }

  struct Closest {
    double square;
    TriangleId triangle;
    Vec3 point;
  };

  void offer_triangles_at(VertexId v, const Vec3& site, Closest& best) const {
    for (const TriangleId t : input_.fine.triangles_at(v)) {
      const auto& [ia, ib, ic] = input_.fine.triangles[t];
      const Vec3& a = input_.fine.positions[ia];
      const Vec3& b = input_.fine.positions[ib];
      const Vec3& c = input_.fine.positions[ic];
      const auto [x, y, z] = closest_barycentric(site, a, b, c);
      const Vec3 point = x * a + y * b + z * c;
      const Vec3 away = point - site;
      const double square = dot(away, away);
      if (square < best.square || (square == best.square && t < best.triangle)) {
        best = {square, t, point};
      }
    }
  }

  const Mesh& mesh_;
  const SurfaceInput& input_;
  std::optional<NearbySearch> nearby_;
};

Bucketed<VertexId> vertices_of_cells(std::size_t count, const std::vector<RegionId>& labels,
                                     Executor& executor) {
  return bucket_sort<VertexId>(executor, count, labels.size(), [&](std::size_t v, auto&& put) {
    if (labels[v] != no_id) put(labels[v], static_cast<VertexId>(v));
  });
}

}  // namespace

std::vector<SurfacePoint> place_sites(const Mesh& mesh, const SurfaceInput& input,
                                      const std::vector<Vec3>& sites,
                                      const std::vector<RegionId>& labels, Executor& executor) {
  const Bucketed<VertexId> cells = vertices_of_cells(sites.size(), labels, executor);
  const SitePlacer placer(mesh, input);
  std::vector<SurfacePoint> places(sites.size());
  parallel_for(executor, sites.size(), 64,
               [&](std::size_t r) { places[r] = placer.find(sites[r], cells[r]); });
  return places;
}

void place_fitted(const Mesh& mesh, const SurfaceInput& input, const std::vector<Vec3>& fitted,
                  const std::vector<RegionId>& labels, std::span<const VertexId> on_curves,
                  std::size_t first, std::vector<SurfacePoint>& places, Executor& executor) {
  std::vector<std::uint8_t> is_on_curve(input.fine.vertex_count(), 0);
  for (const VertexId v : on_curves) is_on_curve[v] = 1;
  const Bucketed<VertexId> cells = vertices_of_cells(fitted.size(), labels, executor);
  const SitePlacer placer(mesh, input);
  parallel_for(executor, fitted.size(), 64, [&](std::size_t r) {
    if (r < first || places[r].triangle == no_id || fitted[r] == position_of(mesh, places[r])) {
      return;
    }
    places[r] = placer.find_beyond(input.frame.to_unit(fitted[r]), cells[r], is_on_curve);
  });
}

void place_on_curves(const Mesh& mesh, const SurfaceInput& input,
                     std::span<const MovedCurveVertex> moved, const std::vector<RegionId>& labels,
                     std::vector<SurfacePoint>& places, Executor& executor) {
  if (moved.empty()) return;
  const Bucketed<VertexId> cells = vertices_of_cells(places.size(), labels, executor);
  const SitePlacer placer(mesh, input);
  for (const auto& [v, on_curve] : moved) {
    places[v] = placer.find_beyond(on_curve, cells[v], {});
  }
}

void place_corners(const Mesh& mesh, const SurfaceInput& input, std::span<const VertexId> corners,
                   std::vector<SurfacePoint>& places) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const TriangleId origin = input.origin[input.fine.triangles_at(corners[i])[0]];
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3& corner = mesh.positions[mesh.triangles[origin][c]];
      if (input.frame.to_unit(corner) != input.fine.positions[corners[i]]) continue;
      places[i] = {origin, {0, 0, 0}};
      places[i].barycentric[c] = 1;
    }
  }
}

Vec3 position_of(const Mesh& mesh, const SurfacePoint& point) {
  const auto& [a, b, c] = mesh.triangles[point.triangle];
  return point.barycentric[0] * mesh.positions[a] + point.barycentric[1] * mesh.positions[b] +
         point.barycentric[2] * mesh.positions[c];
}

}  // namespace geolloyd
