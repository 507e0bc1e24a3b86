#include "core/repair/crossing_triangles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "core/mesh/exact_signs.h"

namespace geolloyd {
namespace {

using Corners = std::array<Vec3, 3>;

// Brings the corners that two triangles share to their front, in the same order. How many.
std::size_t bring_shared_to_front(Corners& first, Corners& second) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = count; k < 3; ++k) {
      if (first[i] != second[k]) continue;
      std::swap(first[count], first[i]);
      std::swap(second[count], second[k]);
      ++count;
      break;
    }
  }
  return count;
}

int largest_axis_of_normal(const Corners& t) {
  int axis = 0;
  cross(t[1] - t[0], t[2] - t[0]).cwiseAbs().maxCoeff(&axis);
  return axis;
}

// One in which the triangle has an area; nothing where it has none at all.
std::optional<Projection> projection_of(const Corners& t) {
  const int first = largest_axis_of_normal(t);
  for (int i = 0; i < 3; ++i) {
    const Projection projection((first + i) % 3);
    if (projection.orientation(t[0], t[1], t[2]) != 0) return projection;
  }
  return std::nullopt;
}

// Heights of corners, of which the first ones are left out: at least, and at most.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

// Along a direction, from a point; with all that rounding may do.
Extent extent_along(const Vec3& direction, const Vec3& from, const Corners& t, std::size_t first) {
  constexpr double rounding = 1e-15;  // above four roundings of 2^-53 each
  Extent extent;
  for (std::size_t i = first; i < 3; ++i) {
    const Vec3 way = t[i] - from;
    const double height = dot(direction, way);
    const double error = rounding * dot(direction.cwiseAbs(), way.cwiseAbs());
    extent.low = std::min(extent.low, height - error);
    extent.high = std::max(extent.high, height + error);
  }
  return extent;
}

// Whether a plane between them parts them. That it does not says nothing.
bool are_surely_apart(const Corners& first, const Corners& second) {
  const Vec3 between = (first[0] + first[1] + first[2]) - (second[0] + second[1] + second[2]);
  return extent_along(between, first[0], first, 0).low >
         extent_along(between, first[0], second, 0).high;
}

// The same for triangles that share their first corner: for all but that.
bool are_surely_apart_beside_first(const Corners& first, const Corners& second) {
  const Vec3& shared = first[0];
  const Vec3 one = (first[1] - shared) + (first[2] - shared);
  const Vec3 other = (second[1] - shared) + (second[2] - shared);
  const Vec3 between = norm(other) * one - norm(one) * other;
  return extent_along(between, shared, first, 1).low > 0 &&
         extent_along(between, shared, second, 1).high < 0;
}

// Whether a line along one of the two edges of a wedge at a point has it on one side, all of
// another wedge there on the other.
bool does_edge_part(const Corners& wedge, const Corners& other, const Projection& projection) {
  const int turn = projection.orientation(wedge[0], wedge[1], wedge[2]);
  const auto is_beyond = [&](const Vec3& end, int side) {
    return projection.orientation(wedge[0], end, other[1]) == side &&
           projection.orientation(wedge[0], end, other[2]) == side;
  };
  return turn != 0 && (is_beyond(wedge[1], -turn) || is_beyond(wedge[2], turn));
}

// Whether all are strictly on one side.
bool are_on_one_side(const std::array<int, 3>& signs) {
  return signs[0] != 0 && signs[0] == signs[1] && signs[0] == signs[2];
}

bool is_on_one_side_of_plane(const Corners& plane, const Corners& t) {
  const auto side = [&](const Vec3& p) { return orientation(plane[0], plane[1], plane[2], p); };
  return are_on_one_side({side(t[0]), side(t[1]), side(t[2])});
}

// Of a segment in the plane of a triangle, which has an area in the projection. Two convex shapes
// are apart if a side of one of them parts them.
bool does_meet_in_plane(const Vec3& p, const Vec3& q, const Corners& t,
                        const Projection& projection) {
  const int turn = projection.orientation(t[0], t[1], t[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = t[i];
    const Vec3& b = t[(i + 1) % 3];
    if (projection.orientation(a, b, p) == -turn && projection.orientation(a, b, q) == -turn) {
      return false;
    }
  }
  const auto side = [&](const Vec3& corner) { return projection.orientation(p, q, corner); };
  return !are_on_one_side({side(t[0]), side(t[1]), side(t[2])});
}

// Whether a segment has a point of a triangle.
bool does_meet(const Vec3& p, const Vec3& q, const Corners& t, const Projection& projection) {
  const int side_of_p = orientation(t[0], t[1], t[2], p);
  const int side_of_q = orientation(t[0], t[1], t[2], q);
  if (side_of_p * side_of_q > 0) return false;
  if (side_of_p == 0 && side_of_q == 0) return does_meet_in_plane(p, q, t, projection);
  const auto turn = [&](std::size_t i) { return orientation(p, q, t[i], t[(i + 1) % 3]); };
  const auto [least, most] = std::minmax({turn(0), turn(1), turn(2)});
  return least * most >= 0;  // the line does not pass on the left of one edge, right of another
}

bool do_cross_at_edge(const Corners& first, const Corners& second) {
  const auto& [a, b, c] = first;
  const Vec3& d = second[2];
  const Projection likely(largest_axis_of_normal(first));
  if (likely.orientation(a, b, c) * likely.orientation(a, b, d) < 0) return false;
  if (orientation(a, b, c, d) != 0) return false;
  const auto projection = projection_of(first);
  return projection && projection->orientation(a, b, c) * projection->orientation(a, b, d) > 0;
}

// Where they meet beside the corner, they do so at the edge opposite to it of one of them.
bool do_cross_at_corner(const Corners& first, const Corners& second) {
  if (are_surely_apart_beside_first(first, second)) return false;
  const Projection likely(largest_axis_of_normal(first));
  if (does_edge_part(first, second, likely) || does_edge_part(second, first, likely)) return false;
  const auto one = projection_of(first);
  const auto other = projection_of(second);
  return one && other &&
         (does_meet(first[1], first[2], second, *other) ||
          does_meet(second[1], second[2], first, *one));
}

bool do_cross_anywhere(const Corners& first, const Corners& second) {
  if (are_surely_apart(first, second) || is_on_one_side_of_plane(first, second) ||
      is_on_one_side_of_plane(second, first)) {
    return false;
  }
  const auto one = projection_of(first);
  const auto other = projection_of(second);
  if (!one || !other) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (does_meet(first[i], first[(i + 1) % 3], second, *other)) return true;
    if (does_meet(second[i], second[(i + 1) % 3], first, *one)) return true;
  }
  return false;
}

}  // namespace

bool do_cross(const Corners& first, const Corners& second) {
  Corners one = first;
  Corners other = second;
  switch (bring_shared_to_front(one, other)) {
    case 0:
      return do_cross_anywhere(one, other);
    case 1:
      return do_cross_at_corner(one, other);
    case 2:
      return do_cross_at_edge(one, other);
    default:
      return projection_of(one).has_value();
  }
}

}  // namespace geolloyd
