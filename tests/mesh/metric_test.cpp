#include "core/mesh/metric.h"

#include <gtest/gtest.h>

#include "tests/support/surface.h"

namespace geolloyd {
namespace {

Metric random_metric(std::uint64_t n) {
  Metric metric = 0.05 * Metric{};
  for (std::uint64_t i = 0; i < 3; ++i) metric += Metric::square_of(random_point(7, 3 * n + i));
  return metric;
}

TEST(Metric, OfEvenSpaceIsThatOfEuclid) {
  const Vec3 v(1, -2, 2);
  EXPECT_EQ(Metric{}.length(v), 3);
  EXPECT_EQ(Metric{} * v, v);
  EXPECT_EQ(Metric{}.solve(v), v);
  EXPECT_EQ(MetricRoot(Metric{})(v), v);
}

TEST(Metric, CountsSquaresOfDirections) {
  const Metric metric = 9 * Metric::square_of(Vec3::UnitX()) + Metric::square_of(Vec3::UnitY());
  EXPECT_EQ(metric.length({2, 0, 5}), 6);
  EXPECT_EQ(metric.length({0, 2, 5}), 2);
  EXPECT_EQ(metric.trace(), 10);
}

TEST(Metric, HasARootThatMapsItToEvenSpace) {
  for (std::uint64_t n = 0; n < 200; ++n) {
    const Metric metric = random_metric(n);
    const MetricRoot root(metric);
    const Vec3 a = random_point(8, n);
    const Vec3 b = random_point(9, n);
    EXPECT_NEAR(dot(root(a), root(b)), metric.dot(a, b), 1e-13);
    EXPECT_NEAR(dot(root.transposed(a), b), dot(a, root(b)), 1e-13);
  }
}

TEST(Metric, IsSolved) {
  for (std::uint64_t n = 0; n < 200; ++n) {
    const Metric metric = random_metric(n);
    const Vec3 v = random_point(8, n);
    EXPECT_LT(norm(metric * metric.solve(v) - v), 1e-10);
  }
  EXPECT_EQ(Metric::zero().solve({1, 2, 3}), Vec3(0, 0, 0));
}

TEST(Metric, KnowsByHowMuchItsShapeStretches) {
  EXPECT_EQ(Metric{}.largest_stretch(), 1);
  const Metric shape = 9 * Metric::square_of(Vec3::UnitX()) +
                       1.0 / 9 * Metric::square_of(Vec3::UnitY()) +
                       Metric::square_of(Vec3::UnitZ());
  EXPECT_NEAR(shape.largest_stretch(), 3, 1e-12);
}

}  // namespace
}  // namespace geolloyd
