#pragma once

#include <algorithm>

#include "core/base/vec3.h"

namespace geolloyd {

/// The share of the way from `a` to `b` at which their segment is closest to `p`; 0 where both are
/// the same point.
inline double closest_share(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double square = dot(along, along);
  return square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0.0;
}

/// The point of a segment that is closest to `p`.
inline Vec3 closest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  return a + closest_share(p, a, b) * (b - a);
}

}  // namespace geolloyd
