#pragma once

#include <array>
#include <utility>

#include "core/base/vec3.h"

namespace geolloyd {

/// How far a triangle is from an equilateral one of the area asked for:
///
///     sqrt(z + e^2) - e + 2 z^2 + m (s - 1)^2,  z = |sides|^2 / (4 sqrt(3) area) - 1,
///
/// with s for the area over that asked for, e = 0.05 and m = 0.4. The root makes it of first order
/// in the strain, as mean quality is: many triangles are a little strained rather than few a lot.
/// Areas count with their sign, seen along a normal, so that a fold is no gain.
class TriangleStrain {
 public:
  TriangleStrain() = default;
  /// `normal` of length 1; `area` above 0.
  TriangleStrain(Vec3 normal, double area) : normal_(std::move(normal)), area_(area) {}

  /// Adds `weight` times the gradient to `gradient`, if there is one.
  double evaluate(const std::array<Vec3, 3>& corners, double weight,
                  std::array<Vec3, 3>* gradient) const;

 private:
  Vec3 normal_ = Vec3::Zero();
  double area_ = 1;
};

}  // namespace geolloyd
