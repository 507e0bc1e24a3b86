#include <algorithm>
#include <map>

#include "core/remesh/dual_mesh.h"

namespace geolloyd {
namespace {

constexpr double sharp_cosine = 0.8660254037844387;  // of 30 degrees

// Where a region's vertex goes on the boundary.
struct OuterPlace {
  Vec3 position = Vec3::Zero();
  double cosine = sharp_cosine;  // of the angle by which the boundary turns there
  double distance = 0;           // from the site
  bool is_found = false;

  void offer(const Vec3& p, const Vec3& site, double turn_cosine) {
    const double away = norm(p - site);
    const bool is_sharper = turn_cosine < cosine;
    const bool is_as_sharp = turn_cosine == cosine || (turn_cosine > cosine && is_blunt());
    if (!is_found || is_sharper || (is_as_sharp && away < distance)) {
      position = p;
      distance = away;
      cosine = std::min(turn_cosine, sharp_cosine);
      is_found = true;
    }
  }

  [[nodiscard]] bool is_blunt() const { return cosine == sharp_cosine; }
};

Vec3 closest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double squared = dot(along, along);
  const double t = squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
  return a + t * along;
}

}  // namespace

std::vector<Vec3> place_dual(const Mesh& mesh, const RegionSurface& surface,
                             const std::vector<Vec3>& site) {
  std::map<VertexId, std::vector<VertexId>> beside;  // along the boundary
  for (const IrregularEdge& edge : surface.irregular_edges) {
    if (edge.triangles != 1) continue;
    beside[edge.ends[0]].push_back(edge.ends[1]);
    beside[edge.ends[1]].push_back(edge.ends[0]);
  }
  std::vector<OuterPlace> outer(site.size());
  for (const auto& [v, neighbours] : beside) {
    const RegionId r = surface.region[v];
    const Vec3& p = mesh.positions[v];
    double cosine = 1;
    if (neighbours.size() == 2) {
      const Vec3 in = normalized(p - mesh.positions[neighbours[0]]);
      const Vec3 out = normalized(mesh.positions[neighbours[1]] - p);
      if (norm(in) > 0 && norm(out) > 0) cosine = dot(in, out);
    }
    outer[r].offer(p, site[r], cosine);
  }
  for (const IrregularEdge& edge : surface.irregular_edges) {
    const auto [a, b] = edge.ends;
    const RegionId r = surface.region[a];
    if (edge.triangles != 1 || r != surface.region[b]) continue;
    outer[r].offer(closest_on_segment(site[r], mesh.positions[a], mesh.positions[b]), site[r], 1);
  }
  std::vector<Vec3> places = site;
  for (std::size_t r = 0; r < places.size(); ++r) {
    if (outer[r].is_found) places[r] = outer[r].position;
  }
  return places;
}

std::size_t count_flipped(const Mesh& mesh, const RegionSurface& surface, const DualMesh& dual,
                          const std::vector<Vec3>& place) {
  const auto normal = [](const Vec3& a, const Vec3& b, const Vec3& c) {
    return cross(b - a, c - a);
  };
  std::size_t flipped = 0;
  for (std::size_t i = 0; i < dual.triangles.size(); ++i) {
    const Triangle& t = dual.triangles[i];
    const Triangle& corner = surface.triangles[dual.corner[i]];
    const Vec3 there = normal(surface.position(mesh, corner[0]), surface.position(mesh, corner[1]),
                              surface.position(mesh, corner[2]));
    if (dot(normal(place[t[0]], place[t[1]], place[t[2]]), there) < 0) ++flipped;
  }
  return flipped;
}

}  // namespace geolloyd
