// The strain of a triangle is least where it is equilateral and of the area asked for, and its
// gradient is that of the values.
#include "core/surface/fit/triangle_strain.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace geolloyd {
namespace {

using Corners = std::array<Vec3, 3>;

const Vec3 up(0, 0, 1);
const Corners equilateral = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, std::sqrt(0.75), 0)};
const double area_of_equilateral = std::sqrt(3.0) / 4;

double strain_of(const Corners& corners, double area = area_of_equilateral) {
  return TriangleStrain(up, area).evaluate(corners, 1, nullptr);
}

TEST(TriangleStrain, IsNoneOfAnEquilateralTriangle) {
  EXPECT_NEAR(strain_of(equilateral), 0, 1e-9);
  EXPECT_NEAR(strain_of(equilateral, area_of_equilateral / 2), 0.4, 1e-9);  // twice the area
}

TEST(TriangleStrain, GrowsWithTheStrain) {
  double before = strain_of(equilateral);
  for (const double x : {0.6, 0.8, 1.0, 1.5, 3.0}) {
    Corners sheared = equilateral;
    sheared[2].x() = x;
    EXPECT_GT(strain_of(sheared), before) << x;
    before = strain_of(sheared);
  }
}

// Downhill from a fold goes back through no area.
TEST(TriangleStrain, GrowsWithAFold) {
  double before = strain_of(equilateral);
  for (const double y : {0.3, 0.1, 0.0, -0.1, -0.5, -2.0}) {
    Corners folded = equilateral;
    folded[2].y() = y;
    EXPECT_GT(strain_of(folded), before) << y;
    before = strain_of(folded);
  }
}

TEST(TriangleStrain, HasTheGradientOfItsValues) {
  constexpr double step = 1e-6;
  constexpr double weight = 3;
  const std::vector<Corners> triangles = {
      {Vec3(0, 0, 0), Vec3(1, 0.2, 0.1), Vec3(0.3, 0.8, -0.2)},
      {Vec3(0, 0, 0), Vec3(1, 0.2, 0.1), Vec3(0.9, 0.3, -0.2)},
      {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.4, -0.7, 0.1)},  // turned round
  };
  const TriangleStrain strain(normalized(Vec3(0.1, -0.2, 1)), 0.35);
  for (const Corners& corners : triangles) {
    Corners gradient = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    strain.evaluate(corners, weight, &gradient);
    for (std::size_t k = 0; k < 3; ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        Corners less = corners;
        Corners more = corners;
        less[k][axis] -= step;
        more[k][axis] += step;
        const double slope =
            (strain.evaluate(more, 1, nullptr) - strain.evaluate(less, 1, nullptr)) / (2 * step);
        EXPECT_NEAR(gradient[k][axis], weight * slope, 1e-4 * (1 + std::abs(slope)));
      }
    }
  }
}

}  // namespace
}  // namespace geolloyd
