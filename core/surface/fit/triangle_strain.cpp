#include "core/surface/fit/triangle_strain.h"

#include <algorithm>
#include <cmath>

namespace geolloyd {

double TriangleStrain::evaluate(const std::array<Vec3, 3>& corners, double weight,
                                std::array<Vec3, 3>* gradient) const {
  constexpr double epsilon = 0.05;
  constexpr double of_square = 2;
  constexpr double of_area = 0.4;
  constexpr double least_area = 0.05;  // of that asked for; below, the penalty is linear
  constexpr double penalty = 40;
  constexpr double linear_from = 1;
  constexpr double four_roots_of_three = 6.928203230275509;
  const auto& [a, b, c] = corners;
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 bc = c - b;
  const double signed_share = 0.5 * dot(cross(ab, ac), normal_) / area_;
  const double share = std::max(signed_share, least_area);
  const double below = share - signed_share;
  const double scale = 1 / (four_roots_of_three * share * area_);
  const double ratio = scale * (dot(ab, ab) + dot(ac, ac) + dot(bc, bc));
  const double z = std::max(0.0, ratio - 1);
  const double root = std::sqrt(z + epsilon * epsilon);
  const double value = root - epsilon +
                       of_square * (z > linear_from ? linear_from * (2 * z - linear_from) : z * z) +
                       of_area * (share - 1) * (share - 1) + penalty * below;
  if (gradient == nullptr) return value;

  const double by_ratio = 0.5 / root + 2 * of_square * std::min(z, linear_from);
  const double by_share =
      below > 0 ? -penalty : 2 * of_area * (share - 1) - by_ratio * ratio / share;
  const Vec3 by_area = (0.5 * weight * by_share / area_) * normal_;
  const double by_sides = 2 * weight * by_ratio * scale;
  (*gradient)[0] += cross(by_area, bc) - by_sides * (ab + ac);
  (*gradient)[1] += by_sides * (ab - bc) - cross(by_area, ac);
  (*gradient)[2] += cross(by_area, ab) + by_sides * (ac + bc);
  return value;
}

}  // namespace geolloyd
