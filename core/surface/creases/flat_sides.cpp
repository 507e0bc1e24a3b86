#include "core/surface/creases/flat_sides.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/mesh/mesh_measure.h"
#include "core/mesh/segment.h"

namespace geolloyd {
namespace {

constexpr std::size_t most_on_a_side = 200;  // triangles: as many say enough

// A triangle on a side: its normal counts with this sign.
struct SideTriangle {
  TriangleId triangle;
  double sign;
};

}  // namespace

bool FlatSides::has_one(EdgeId e) const {
  const std::span<const CornerId> corners = angles_.edges().corners(e);
  return std::any_of(corners.begin(), corners.end(),
                     [&](CornerId c) { return is_flat(e, triangle_of(c)); });
}

// Triangles are taken in the order in which they are reached from the edge.
bool FlatSides::is_flat(EdgeId e, TriangleId side) const {
  const Mesh& mesh = angles_.mesh();
  const double triangle_side = std::sqrt(triangle_area(mesh, mesh.triangles[side]));
  const double reach = std::max(spacing_ / 2, std::min(2 * triangle_side, 8 * spacing_));
  const double square = reach * reach;
  std::vector<SideTriangle> reached = {{side, 1}};
  std::vector<TriangleId> known = {side};  // ascending
  Vec3 normals = Vec3::Zero();
  double area = 0;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const SideTriangle here = reached[i];
    const double share = std::min(triangle_area(mesh, mesh.triangles[here.triangle]), square / 2);
    normals += (here.sign * share) * angles_.normal(here.triangle);
    area += share;
    for_each_corner(mesh, here.triangle, [&](CornerId c) {
      const EdgeId next = edge_opposite(c);
      const TriangleId beyond = triangle_beyond(next, here.triangle);
      if (beyond == no_id || reached.size() >= most_on_a_side || !is_near(e, next, reach)) return;
      const auto place = std::lower_bound(known.begin(), known.end(), beyond);
      if (place != known.end() && *place == beyond) return;
      known.insert(place, beyond);
      reached.push_back({beyond, angles_.is_turned_round(next) ? -here.sign : here.sign});
    });
  }
  constexpr double least_area = 0.45;
  constexpr double least_mean = 0.995;
  return area >= least_area * square && norm(normals) >= least_mean * area;
}

EdgeId FlatSides::edge_opposite(CornerId c) const {
  const auto& ends = angles_.edges().ends;
  const auto edge = ascending(edge_start(angles_.mesh(), c), edge_end(angles_.mesh(), c));
  return static_cast<EdgeId>(std::lower_bound(ends.begin(), ends.end(), edge) - ends.begin());
}

TriangleId FlatSides::triangle_beyond(EdgeId e, TriangleId t) const {
  const std::span<const CornerId> corners = angles_.edges().corners(e);
  if (corners.size() != 2 || std::binary_search(sharp_.begin(), sharp_.end(), e)) return no_id;
  return triangle_of(corners[triangle_of(corners[0]) == t ? 1 : 0]);
}

// By three points of the other edge.
bool FlatSides::is_near(EdgeId e, EdgeId other, double reach) const {
  const std::vector<Vec3>& positions = angles_.mesh().positions;
  const Vec3& a = positions[angles_.edges().ends[e][0]];
  const Vec3& b = positions[angles_.edges().ends[e][1]];
  const Vec3& p = positions[angles_.edges().ends[other][0]];
  const Vec3& q = positions[angles_.edges().ends[other][1]];
  const auto is_within = [&](const Vec3& x) {
    const Vec3 away = x - closest_on_segment(x, a, b);
    return dot(away, away) <= reach * reach;
  };
  return is_within(p) || is_within(q) || is_within((p + q) / 2);
}

}  // namespace geolloyd
