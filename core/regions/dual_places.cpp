#include "core/regions/dual_places.h"

#include <algorithm>
#include <array>
#include <span>

#include "core/mesh/segment.h"
#include "core/regions/dual_place_repair.h"

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

// From a vertex of the boundary to a neighbour along the boundary.
using BoundaryStep = std::array<VertexId, 2>;

// In both directions, ascending.
std::vector<BoundaryStep> boundary_steps(const RegionSurface& surface) {
  std::vector<BoundaryStep> steps;
  for (const IrregularEdge& edge : surface.irregular_edges) {
    if (edge.triangles != 1) continue;
    steps.push_back({edge.ends[0], edge.ends[1]});
    steps.push_back({edge.ends[1], edge.ends[0]});
  }
  std::sort(steps.begin(), steps.end());
  return steps;
}

// Cosine of the angle by which the boundary turns at a vertex; 1 where it has no direction.
double turn_cosine(const Mesh& mesh, std::span<const BoundaryStep> steps) {
  if (steps.size() != 2) return 1;
  const Vec3& p = mesh.positions[steps[0][0]];
  const Vec3 in = normalized(p - mesh.positions[steps[0][1]]);
  const Vec3 out = normalized(mesh.positions[steps[1][1]] - p);
  return norm(in) > 0 && norm(out) > 0 ? dot(in, out) : 1;
}

// Per region.
std::vector<OuterPlace> find_outer_places(const Mesh& mesh, const RegionSurface& surface,
                                          const std::vector<Vec3>& site) {
  const std::vector<BoundaryStep> steps = boundary_steps(surface);
  std::vector<OuterPlace> outer(site.size());
  for (auto first = steps.begin(); first != steps.end();) {
    const VertexId v = (*first)[0];
    const auto last =
        std::find_if(first, steps.end(), [v](const BoundaryStep& step) { return step[0] != v; });
    const RegionId r = surface.region[v];
    outer[r].offer(mesh.positions[v], site[r], turn_cosine(mesh, std::span(first, last)));
    first = last;
  }
  for (const IrregularEdge& edge : surface.irregular_edges) {
    const auto [a, b] = edge.ends;
    const RegionId r = surface.region[a];
    if (edge.triangles != 1 || r != surface.region[b]) continue;
    outer[r].offer(closest_on_segment(site[r], mesh.positions[a], mesh.positions[b]), site[r], 1);
  }
  return outer;
}

}  // namespace

std::vector<Vec3> place_dual(const Mesh& mesh, const RegionSurface& surface, const DualMesh& dual,
                             const std::vector<Vec3>& site) {
  const std::vector<OuterPlace> outer = find_outer_places(mesh, surface, site);
  PlaceChoices choices{site, {}, {}, {}};
  std::vector<Vec3> places = site;
  for (std::size_t r = 0; r < places.size(); ++r) {
    if (outer[r].is_found) places[r] = outer[r].position;
    choices.is_outer.push_back(outer[r].is_found ? 1 : 0);
    choices.is_at_turn.push_back(outer[r].is_found && !outer[r].is_blunt() ? 1 : 0);
  }
  for (const BoundaryStep& step : boundary_steps(surface)) {
    choices.boundary.emplace_back(surface.region[step[0]], step[0]);
  }
  std::sort(choices.boundary.begin(), choices.boundary.end());
  repair_places(mesh, surface, dual, choices, places);
  return places;
}

std::size_t count_flipped(const Mesh& mesh, const RegionSurface& surface, const DualMesh& dual,
                          const std::vector<Vec3>& place) {
  std::size_t flipped = 0;
  for (std::size_t i = 0; i < dual.triangles.size(); ++i) {
    if (signed_flatness(mesh, surface, dual, i, place) < 0) ++flipped;
  }
  return flipped;
}

}  // namespace geolloyd
