#pragma once

#include <array>

#include "core/mesh/segment.h"

namespace geolloyd {

/// Weights of the second and third corner at the point of a triangle that is closest to the origin
/// (not negative, at most 1 together up to rounding). The best of three points on its edges and of
/// the foot of the perpendicular where that is inside: no triangle is so thin, however its weights
/// are rounded, that the result would not be close to the best.
inline std::array<double, 2> barycentric_closest_to_origin(const std::array<Vec3, 3>& corner) {
  const Vec3& a = corner[0];
  const Vec3& b = corner[1];
  const Vec3& c = corner[2];
  std::array<double, 2> best = {0, 0};
  double least = dot(a, a);
  const auto offer = [&](double v, double w) {
    const Vec3 point = a + v * (b - a) + w * (c - a);
    const double square = dot(point, point);
    if (square < least) {
      least = square;
      best = {v, w};
    }
  };
  const Vec3 origin = Vec3::Zero();
  const double on_bc = closest_share(origin, b, c);
  offer(closest_share(origin, a, b), 0);
  offer(0, closest_share(origin, a, c));
  offer(1 - on_bc, on_bc);
  const Vec3 normal = cross(b - a, c - a);
  const double u = dot(cross(b, c), normal);
  const double v = dot(cross(c, a), normal);
  const double w = dot(cross(a, b), normal);
  if (u > 0 && v > 0 && w > 0) offer(v / (u + v + w), w / (u + v + w));
  return best;
}

}  // namespace geolloyd
