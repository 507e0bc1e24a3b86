#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include "core/base/loops.h"
#include "core/base/vec3.h"

namespace geolloyd {

/// The smallest box along the axes around some points.
struct BoundingBox {
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();

  [[nodiscard]] Vec3 extent() const { return high - low; }
  [[nodiscard]] Vec3 middle() const { return (low + high) / 2; }
};

/// A box that grows from nothing.
struct GrowingBox {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());

  void add(const Vec3& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  GrowingBox& operator+=(const GrowingBox& more) {
    low = low.cwiseMin(more.low);
    high = high.cwiseMax(more.high);
    return *this;
  }
};

inline GrowingBox box_around(std::span<const Vec3> points) {
  GrowingBox box;
  for (const Vec3& point : points) box.add(point);
  return box;
}

/// The box of position_of(i) for i < count. At the origin, and empty, without any.
template <class PositionOf>
BoundingBox bounding_box(std::size_t count, PositionOf&& position_of,
                         Executor& executor = sequential()) {
  if (count == 0) return {};
  const auto box = parallel_reduce<GrowingBox>(executor, count, small_items,
                                               [&](std::size_t begin, std::size_t end) {
                                                 GrowingBox part;
                                                 for (std::size_t i = begin; i < end; ++i) {
                                                   part.add(position_of(i));
                                                 }
                                                 return part;
                                               });
  return {box.low, box.high};
}

inline BoundingBox bounding_box(std::span<const Vec3> points) {
  return bounding_box(points.size(), [&](std::size_t i) { return points[i]; });
}

}  // namespace geolloyd
