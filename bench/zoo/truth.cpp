#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "bench/zoo/part.h"
#include "core/mesh/mesh_edges.h"

namespace geolloyd::zoo {
namespace {

class TruthFinder {
 public:
  // A closed one.
  explicit TruthFinder(const Mesh& mesh)
      : mesh_(mesh), edges_(find_edges(mesh)), is_sharp_(3 * mesh.triangle_count(), 0) {
    for (std::size_t e = 0; e < edges_.size(); ++e) look_at(e);
  }

  void write(Truth& truth) {
    truth.forced_angle = std::min(60.0, smallest_angle() * 180 / std::numbers::pi);
    truth.sharp = std::move(sharp_);
  }

 private:
  [[nodiscard]] Vec3 normal_of(TriangleId t) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    const auto& p = mesh_.positions;
    return normalized(cross(p[b] - p[a], p[c] - p[a]));
  }

  // Across the triangle, from the edge opposite to the corner.
  [[nodiscard]] Vec3 across(CornerId corner) const {
    const Vec3& a = mesh_.positions[edge_start(mesh_, corner)];
    const Vec3& b = mesh_.positions[edge_end(mesh_, corner)];
    return normalized(cross(normal_of(triangle_of(corner)), b - a));
  }

  void look_at(std::size_t e) {
    const auto corners = edges_.corners(e);
    if (dot(normal_of(triangle_of(corners[0])), normal_of(triangle_of(corners[1]))) >
        sharp_cosine) {
      return;
    }
    for (const CornerId c : corners) is_sharp_[c] = 1;
    const auto [a, b] = edges_.ends[e];
    sharp_.push_back(
        {{mesh_.positions[a], mesh_.positions[b]}, {across(corners[0]), across(corners[1])}});
  }

  [[nodiscard]] double angle_at(CornerId corner) const {
    const Vec3& p = mesh_.positions[apex(mesh_, corner)];
    const Vec3 a = mesh_.positions[edge_start(mesh_, corner)] - p;
    const Vec3 b = mesh_.positions[edge_end(mesh_, corner)] - p;
    return std::atan2(norm(cross(a, b)), dot(a, b));
  }

  // From this corner on, around its vertex, up to a sharp edge or all the way.
  struct Sector {
    double angle = 0;
    bool is_whole = false;
  };
  [[nodiscard]] Sector sector_from(CornerId corner, const std::vector<CornerId>& opposite) const {
    Sector sector{angle_at(corner), false};
    CornerId at = corner;
    while (is_sharp_[corner_at_start(at)] == 0) {
      at = corner_at_start(opposite[corner_at_start(at)]);
      if (at == corner) return {sector.angle, true};
      sector.angle += angle_at(at);
    }
    return sector;
  }

  // That a vertex must have: between two sharp edges that follow each other, or one of the three
  // at the least around a tip.
  [[nodiscard]] double smallest_angle() const {
    std::vector<CornerId> opposite(is_sharp_.size(), no_id);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const auto corners = edges_.corners(e);
      opposite[corners[0]] = corners[1];
      opposite[corners[1]] = corners[0];
    }
    double smallest = std::numbers::pi;
    for (CornerId c = 0; c < is_sharp_.size(); ++c) {
      const bool begins_at_sharp = is_sharp_[corner_at_end(c)] != 0;
      const Sector sector = sector_from(c, opposite);
      if (begins_at_sharp) smallest = std::min(smallest, sector.angle);
      if (sector.is_whole) smallest = std::min(smallest, sector.angle / 3);
    }
    return smallest;
  }

  const Mesh& mesh_;
  MeshEdges edges_;
  std::vector<std::uint8_t> is_sharp_;  // per corner: the edge opposite to it
  std::vector<SharpEdge> sharp_;
};

Part with_solid(std::string name, std::string kind, Solid solid) {
  Part part{std::move(name), std::move(kind), std::move(solid.mesh), {}};
  part.truth.volume = solid.volume;
  part.truth.parts = std::move(solid.parts);
  part.truth.rims = std::move(solid.rims);
  return part;
}

}  // namespace

Part part_of(std::string name, std::string kind, Solid solid) {
  Part part = with_solid(std::move(name), std::move(kind), std::move(solid));
  TruthFinder(part.mesh).write(part.truth);
  return part;
}

Part soft_part_of(std::string name, Solid solid) {
  Part part = with_solid(std::move(name), soft_kind, std::move(solid));
  part.truth.rims.clear();
  part.is_soft = true;
  return part;
}

}  // namespace geolloyd::zoo
