#pragma once

#include <cmath>

#include "geolloyd/types.h"

namespace geolloyd {

/// Coordinates beyond this are refused: their fourth power, an area squared, must not overflow.
inline constexpr double largest_coordinate = 1e75;

/// False also for what is not a number.
inline bool is_usable(double coordinate) {
  return std::abs(coordinate) <= largest_coordinate;
}

// Eigen chooses the order of a sum by the vector unit it compiles for, and the last bit of a length
// decides its ticks. These reductions have one order on every machine; the rest of Eigen is used as
// it is.

inline double dot(const Vec3& a, const Vec3& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

inline double norm(const Vec3& a) {
  return std::sqrt(dot(a, a));
}

inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}

/// `a` scaled to length 1; a zero vector stays zero.
inline Vec3 normalized(const Vec3& a) {
  const double length = norm(a);
  return length > 0 ? Vec3(a / length) : a;
}

}  // namespace geolloyd
