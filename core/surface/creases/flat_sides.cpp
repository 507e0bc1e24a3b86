#include "core/surface/creases/flat_sides.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/mesh/mesh_measure.h"
#include "core/mesh/segment.h"
#include "core/surface/features/degrees.h"

namespace geolloyd {
namespace {

constexpr std::size_t most_on_a_side = 200;  // triangles: as many say enough

// A triangle on a side: its normal counts with this sign.
struct SideTriangle {
  TriangleId triangle;
  double sign;
};

// The point of a triangle's edges that is nearest: long triangles are where they come near.
Vec3 nearest_on_rim(const Mesh& mesh, TriangleId t, const Vec3& p) {
  Vec3 nearest = mesh.positions[mesh.triangles[t][0]];
  for_each_corner(mesh, t, [&](CornerId c) {
    const Vec3 x = closest_on_segment(p, mesh.positions[edge_start(mesh, c)],
                                      mesh.positions[edge_end(mesh, c)]);
    if (dot(x - p, x - p) < dot(nearest - p, nearest - p)) nearest = x;
  });
  return nearest;
}

// The normals beside an edge, as a mean that changes evenly along the edge: constant on a plane,
// and nearly so beside the rims of cylinders and cones.
class NormalsAlong {
 public:
  void add(double weight, double place, const Vec3& normal) {
    weight_ += weight;
    place_ += weight * place;
    square_ += weight * place * place;
    normal_ += weight * normal;
    product_ += (weight * place) * normal;
  }

  [[nodiscard]] double weight() const { return weight_; }

  /// Whether they are `mean` long in the mean; or, where they turn along the edge, once that turn
  /// is taken off.
  [[nodiscard]] bool agree(double mean) const {
    if (norm(normal_) >= mean * weight_) return true;
    constexpr double most_off = 0.004;
    constexpr double least_turned = 0.8;  // the mean of an arc of 130 degrees
    if (norm(normal_) < least_turned * weight_) return false;
    const double off = weight_ - dot(normal_, normal_) / weight_;
    const double spread = square_ - place_ * place_ / weight_;
    const Vec3 turn = product_ - (place_ / weight_) * normal_;
    return spread > 0 && off - dot(turn, turn) / spread <= most_off * weight_;
  }

 private:
  double weight_ = 0;
  double place_ = 0;
  double square_ = 0;
  Vec3 normal_ = Vec3::Zero();
  Vec3 product_ = Vec3::Zero();
};

}  // namespace

bool FlatSides::has_enough(EdgeId e) const {
  constexpr double folded_cosine = cosine_of_degrees(122);
  const std::span<const CornerId> corners = angles_.edges().corners(e);
  const auto is_beside = [&](CornerId c) { return is_flat(e, triangle_of(c)); };
  return angles_.is_as_sharp(e, folded_cosine)
             ? std::all_of(corners.begin(), corners.end(), is_beside)
             : std::any_of(corners.begin(), corners.end(), is_beside);
}

bool FlatSides::has_planes(EdgeId e) const {
  const std::span<const CornerId> corners = angles_.edges().corners(e);
  return angles_.length(e) >= spacing_ &&
         std::all_of(corners.begin(), corners.end(),
                     [&](CornerId c) { return is_on_plane(triangle_of(c)); });
}

bool FlatSides::is_on_plane(TriangleId side) const {
  const Mesh& mesh = angles_.mesh();
  constexpr double least_cosine = cosine_of_degrees(0.2);
  constexpr double least_area = 4;  // in squares of a spacing
  std::vector<TriangleId> known = {side};
  double area = 0;
  for (std::size_t i = 0; i < known.size(); ++i) {
    area += triangle_area(mesh, mesh.triangles[known[i]]);
    if (i > 0 && area >= least_area * spacing_ * spacing_) return true;
    for_each_corner(mesh, known[i], [&](CornerId c) {
      const TriangleId beyond = triangle_beyond(edge_opposite(c), known[i]);
      if (beyond == no_id || known.size() >= most_on_a_side) return;
      if (std::abs(dot(angles_.normal(side), angles_.normal(beyond))) < least_cosine) return;
      if (std::find(known.begin(), known.end(), beyond) == known.end()) known.push_back(beyond);
    });
  }
  return false;
}

// Triangles are taken in the order in which they are reached from the edge.
bool FlatSides::is_flat(EdgeId e, TriangleId side) const {
  const Mesh& mesh = angles_.mesh();
  const double triangle_side = std::sqrt(triangle_area(mesh, mesh.triangles[side]));
  const double reach =
      std::max(spacing_ / 2, std::min({2 * triangle_side, 2 * angles_.length(e), 8 * spacing_}));
  const double square = reach * reach;
  std::vector<SideTriangle> reached = {{side, 1}};
  std::vector<TriangleId> known = {side};  // ascending
  const auto& [a, b] = angles_.edges().ends[e];
  const Vec3 along = normalized(mesh.positions[b] - mesh.positions[a]);
  const Vec3 middle = (mesh.positions[a] + mesh.positions[b]) / 2;
  NormalsAlong normals;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const SideTriangle here = reached[i];
    const double share = std::min(triangle_area(mesh, mesh.triangles[here.triangle]), square / 2);
    const double at = dot(nearest_on_rim(mesh, here.triangle, middle) - middle, along);
    normals.add(share, at, here.sign * angles_.normal(here.triangle));
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
  return normals.weight() >= least_area * square && normals.agree(least_mean);
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
