#pragma once

#include <cmath>

#include "core/base/vec3.h"

namespace geolloyd {

/// Two directions that span the plane at a right angle to `normal`; all three have length 1.
struct PlaneAxes {
  Vec3 first;
  Vec3 second;
};

/// The first is at a right angle to the axis of coordinates that is nearest to the plane.
inline PlaneAxes plane_axes(const Vec3& normal) {
  int axis = 0;
  for (const int other : {1, 2}) {
    if (std::abs(normal[other]) < std::abs(normal[axis])) axis = other;
  }
  Vec3 unit = Vec3::Zero();
  unit[axis] = 1;
  const Vec3 first = normalized(cross(normal, unit));
  return {first, cross(normal, first)};
}

/// `v`, of the plane at a right angle to `from`, after the smallest turn that takes `from` to `to`,
/// both of length 1 and not opposite: parallel transport between neighbouring tangent planes.
inline Vec3 transported(const Vec3& v, const Vec3& from, const Vec3& to) {
  return v - dot(to, v) / (1 + dot(from, to)) * (from + to);
}

}  // namespace geolloyd
