#include "core/repair/crossing_triangles.h"

#include <algorithm>

namespace geolloyd {
namespace {

using Corners = std::array<Vec3, 3>;

// Of triangles whose coordinates are 1 at most.
constexpr double slack = 1e-11;

struct Extent {
  double low;
  double high;
};

Extent extent_along(const Vec3& axis, const Corners& t) {
  const auto [low, high] = std::minmax({dot(axis, t[0]), dot(axis, t[1]), dot(axis, t[2])});
  return {low, high};
}

// Whether nothing but the border of one is on the side of the other. An axis without a direction
// parts nothing.
bool are_parted_along(const Vec3& axis, const Corners& first, const Corners& second) {
  const double length = norm(axis);
  if (length <= slack) return false;
  const Extent one = extent_along(axis, first);
  const Extent other = extent_along(axis, second);
  const double least = slack * length;
  return one.high <= other.low + least || other.high <= one.low + least;
}

// From a corner to the next, of length 1: so what is parallel is so by its angle, not by its size.
Vec3 edge_of(const Corners& t, std::size_t corner) {
  return normalized(t[(corner + 1) % 3] - t[corner]);
}

Vec3 normal_of(const Corners& t) {
  return cross(edge_of(t, 0), edge_of(t, 1));
}

bool are_in_one_plane(const Vec3& normal, const Corners& first, const Corners& second) {
  const double least = slack * norm(normal);
  const Extent one = extent_along(normal, first);
  const Extent other = extent_along(normal, second);
  return other.low >= one.low - least && other.high <= one.high + least;
}

bool are_parted_in_plane(const Vec3& normal, const Corners& first, const Corners& second) {
  for (const Corners* t : {&first, &second}) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (are_parted_along(cross(normal, edge_of(*t, i)), first, second)) return true;
    }
  }
  return false;
}

// Two convex bodies are apart if they are along the normal of a face of one, or along a direction
// at right angles to an edge of each (Gottschalk, Lin, Manocha 1996).
bool are_parted_in_space(const Corners& first, const Corners& second) {
  if (are_parted_along(normal_of(first), first, second)) return true;
  if (are_parted_along(normal_of(second), first, second)) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (are_parted_along(cross(edge_of(first, i), edge_of(second, k)), first, second)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

bool do_cross(const Corners& first, const Corners& second) {
  const Vec3 origin = first[0];
  double size = 0;
  for (const Corners* t : {&first, &second}) {
    for (const Vec3& p : *t) size = std::max(size, (p - origin).cwiseAbs().maxCoeff());
  }
  if (!(size > 0)) return false;
  const auto scaled = [&](const Corners& t) -> Corners {
    return {Vec3((t[0] - origin) / size), Vec3((t[1] - origin) / size),
            Vec3((t[2] - origin) / size)};
  };
  const Corners one = scaled(first);
  const Corners other = scaled(second);
  const Vec3 normal = normal_of(one);
  if (norm(normal) > slack && are_in_one_plane(normal, one, other)) {
    return !are_parted_in_plane(normal, one, other);
  }
  return !are_parted_in_space(one, other);
}

}  // namespace geolloyd
