#pragma once

#include <algorithm>

#include "core/base/bounding_box.h"

namespace geolloyd {

/// Moves and scales positions without any rounding: axes are moved only where all coordinates are
/// so far from 0 that differences of them are exact, and the scale is a power of two. Then no
/// coordinate is far beyond 1.
struct ExactFrame {
  Vec3 origin = Vec3::Zero();
  double scale = 1;

  explicit ExactFrame(const BoundingBox& box) {
    for (int axis = 0; axis < 3; ++axis) {
      origin[axis] = origin_between(box.low[axis], box.high[axis]);
    }
    const double widest = box.extent().maxCoeff();
    constexpr double most = 0x1p1000;
    while (widest * scale > 1) scale /= 2;
    while (widest > 0 && scale < most && widest * scale <= 0.5) scale *= 2;
  }

  [[nodiscard]] Vec3 operator()(const Vec3& p) const { return (p - origin) * scale; }

 private:
  // Sterbenz: a difference is exact where neither number is more than twice the other.
  static double origin_between(double low, double high) {
    const bool is_far = low > 0 ? high <= 2 * low : high < 0 && low >= 2 * high;
    return is_far ? low + (high - low) / 2 : 0;
  }
};

}  // namespace geolloyd
