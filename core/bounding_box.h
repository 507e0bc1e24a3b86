#pragma once

#include <span>

#include "core/vec3.h"

namespace geolloyd {

/// The smallest box along the axes around some points.
struct BoundingBox {
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();

  [[nodiscard]] Vec3 extent() const { return high - low; }
  [[nodiscard]] Vec3 middle() const { return (low + high) / 2; }
};

/// At the origin, and empty, without any points.
inline BoundingBox bounding_box(std::span<const Vec3> points) {
  if (points.empty()) return {};
  BoundingBox box{points.front(), points.front()};
  for (const Vec3& p : points) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

}  // namespace geolloyd
