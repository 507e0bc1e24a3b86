#include "core/surface/fit/lbfgs.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace geolloyd {
namespace {

// Points on springs of their own, and one between each two that follow.
class Springs {
 public:
  explicit Springs(std::size_t count) : count_(count) {}

  double operator()(const std::vector<Vec3>& x, std::vector<Vec3>& gradient) const {
    double value = 0;
    for (std::size_t i = 0; i < count_; ++i) gradient[i] = Vec3::Zero();
    for (std::size_t i = 0; i < count_; ++i) {
      const Vec3 way = x[i] - home(i);
      value += stiffness(i) * dot(way, way);
      gradient[i] += 2 * stiffness(i) * way;
      if (i == 0) continue;
      const Vec3 between = (x[i] - home(i)) - (x[i - 1] - home(i - 1));
      value += 5 * dot(between, between);
      gradient[i] += 10 * between;
      gradient[i - 1] -= 10 * between;
    }
    return value;
  }

  static Vec3 home(std::size_t i) { return {static_cast<double>(i), 1, -2}; }
  static double stiffness(std::size_t i) { return i % 3 == 0 ? 1 : 30; }

 private:
  std::size_t count_;
};

TEST(Lbfgs, FindsTheLeastOfAQuadraticFunction) {
  constexpr std::size_t count = 40;
  const std::vector<double> even(count, 0.05);
  std::vector<Vec3> x(count, Vec3(3, 3, 3));
  descend(Springs(count), {even, 100, 200}, x);
  for (std::size_t i = 0; i < count; ++i) EXPECT_LT(norm(x[i] - Springs::home(i)), 0.01) << i;
}

TEST(Lbfgs, NeverEndsHigherThanItBegan) {
  constexpr std::size_t count = 10;
  const Springs springs(count);
  for (const double inverse_stiffness : {1e-6, 1.0, 1e6}) {
    const std::vector<double> preconditioner(count, inverse_stiffness);
    std::vector<Vec3> x(count, Vec3(3, 3, 3));
    std::vector<Vec3> gradient(count);
    const double before = springs(x, gradient);
    descend(springs, {preconditioner, 100, 5}, x);
    EXPECT_LE(springs(x, gradient), before);
  }
}

TEST(Lbfgs, MovesNoPointFartherThanItMay) {
  const std::vector<double> even(1, 1);
  std::vector<Vec3> x = {Vec3(100, 1, -2)};
  descend(Springs(1), {even, 0.25, 1}, x);
  EXPECT_NEAR(x[0].x(), 99.75, 1e-12);
}

TEST(Lbfgs, StaysWhereNothingIsLower) {
  const std::vector<double> even(1, 1);
  std::vector<Vec3> x = {Springs::home(0)};
  descend(Springs(1), {even, 1, 10}, x);
  EXPECT_EQ(x[0], Springs::home(0));
}

}  // namespace
}  // namespace geolloyd
