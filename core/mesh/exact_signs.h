#pragma once

#include <array>

#include "core/base/vec3.h"

namespace geolloyd {

// Signs of determinants: those of the exact numbers, by rounded arithmetic where its error cannot
// reach the sign, else by sums without rounding (Shewchuk 1997). They hold for coordinates that are
// 0 or have a magnitude from 1e-75 to largest_coordinate, so that nothing overflows or underflows.

using Point2 = std::array<double, 2>;

/// 1 where a, b and c turn to the left, -1 to the right, 0 in a line.
int orientation(const Point2& a, const Point2& b, const Point2& c);

/// A view along an axis: onto the plane of the two others.
struct Projection {
  int x;
  int y;

  explicit Projection(int axis) : x((axis + 1) % 3), y((axis + 2) % 3) {}
  Point2 operator()(const Vec3& p) const { return {p[x], p[y]}; }
  [[nodiscard]] int orientation(const Vec3& a, const Vec3& b, const Vec3& c) const {
    return geolloyd::orientation((*this)(a), (*this)(b), (*this)(c));
  }
};

/// -1 where d is on the side of the plane from which a, b and c turn to the left, 1 on the other
/// one, 0 in the plane.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace geolloyd
