#include "core/fields/metric_mean.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/random.h"
#include "core/base/vec3.h"
#include "core/fields/principal_direction.h"
#include "core/fields/tangent_field.h"
#include "core/graph/arc_length.h"

namespace geolloyd {
namespace {

using std::numbers::pi;

TangentSpace in_plane(double angle, double along, double across) {
  return {
      {std::cos(angle), std::sin(angle), 0}, {-std::sin(angle), std::cos(angle), 0}, along, across};
}

TangentSpace random_space(std::uint64_t i) {
  const auto unit = [&](std::uint64_t k) { return random_unit(7, 10 * i + k); };
  const auto direction = [&](std::uint64_t k) {
    return normalized({unit(k) - 0.5, unit(k + 1) - 0.5, 0.1 * (unit(k + 2) - 0.5)});
  };
  return {direction(0), direction(3), 0.1 + 9 * unit(6), 0.1 + 9 * unit(7)};
}

std::vector<TangentSpace> ways_to_write(const TangentSpace& s) {
  std::vector<TangentSpace> all;
  for (const double sign_t : {1.0, -1.0}) {
    for (const double sign_b : {1.0, -1.0}) {
      const Vec3 t = sign_t * s.tangent;
      const Vec3 b = sign_b * s.bitangent;
      all.push_back({t, b, s.tangent_magnitude, s.bitangent_magnitude});
      all.push_back({b, t, s.bitangent_magnitude, s.tangent_magnitude});
    }
  }
  return all;
}

void expect_same_metric(const TangentSpace& a, const TangentSpace& b, double tolerance) {
  for (const Vec3& d :
       {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 1, 0), Vec3(1, 0, 1), Vec3(0, 1, 1)}) {
    ASSERT_NEAR(measure(d, a, Norm::geodesic), measure(d, b, Norm::geodesic), tolerance);
  }
}

TEST(PrincipalDirection, IsThatOfHalfTheAngle) {
  EXPECT_EQ(principal_direction(0, 0), (std::array<double, 2>{1, 0}));
  for (int i = -90; i <= 90; ++i) {
    const double angle = i * pi / 180;
    const auto [cosine, sine] =
        principal_direction(3 * std::cos(2 * angle), 3 * std::sin(2 * angle));
    EXPECT_NEAR(std::abs(cosine * std::cos(angle) + sine * std::sin(angle)), 1, 1e-15) << i;
  }
}

TEST(MetricMean, OfOneSpaceIsItsMetricWithPrincipalDirections) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    const TangentSpace space = random_space(i);
    const TangentSpace mean = metric_mean(std::array{space});
    expect_same_metric(mean, space, 1e-7);  // directions nearly in one line lose half the digits
    EXPECT_NEAR(dot(mean.tangent, mean.bitangent), 0, 1e-14);
    EXPECT_GE(mean.tangent_magnitude, mean.bitangent_magnitude);
  }
}

TEST(MetricMean, DependsNeitherOnOrderNorOnHowSpacesAreWritten) {
  for (std::uint64_t i = 0; i < 30; ++i) {
    std::array spaces = {random_space(3 * i), random_space(3 * i + 1), random_space(3 * i + 2)};
    const TangentSpace expected = metric_mean(spaces);
    std::array<std::size_t, 3> order = {0, 1, 2};
    do {
      for (const TangentSpace& same : ways_to_write(spaces[order[0]])) {
        expect_same_metric(metric_mean(std::array{same, spaces[order[1]], spaces[order[2]]}),
                           expected, 1e-12);
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

// Two spaces of 4 to 1 at an angle d: their doubled angles leave cos d of the stretch.
TEST(MetricMean, OfATurnedSpaceIsKnown) {
  for (const int degrees : {0, 1, 10, 30, 44, 46, 60, 89}) {
    const double d = degrees * pi / 180;
    const TangentSpace mean = metric_mean(std::array{in_plane(0, 4, 1), in_plane(d, 4, 1)});
    const double stretch = 1.5 * std::cos(d) * (2 - std::cos(d));
    expect_same_metric(mean, in_plane(d / 2, 2.5 + stretch, 2.5 - stretch), 1e-14);
  }
}

TEST(MetricMean, OfDirectionsThatCancelIsIsotropic) {
  const TangentSpace crossed = metric_mean(std::array{in_plane(0, 4, 1), in_plane(pi / 2, 4, 1)});
  expect_same_metric(crossed, in_plane(0, 2.5, 2.5), 1e-14);
  // Around a singularity of index 1 or 1/2 three corners are a third or a sixth of a turn apart.
  for (const double turn : {2 * pi / 3, pi / 3}) {
    const TangentSpace mean =
        metric_mean(std::array{in_plane(0, 9, 1), in_plane(turn, 9, 1), in_plane(2 * turn, 9, 1)});
    expect_same_metric(mean, in_plane(0, 5, 5), 1e-14);
  }
}

// Pairs change partners at 45 degrees, and then each magnitude is averaged with the other one.
TEST(MetricMean, HasNoJumpWherePairsChangePartners) {
  const auto jump = [](Averaging averaging) {
    const TangentSpace fixed = in_plane(0, 9, 1);
    return std::abs(
        measure({1, 0, 0}, average(fixed, in_plane(0.785, 9, 1), averaging), Norm::geodesic) -
        measure({1, 0, 0}, average(fixed, in_plane(0.786, 9, 1), averaging), Norm::geodesic));
  };
  EXPECT_GT(jump(Averaging::pairwise), 3);
  EXPECT_LT(jump(Averaging::metric), 0.02);
}

TEST(MetricMean, AnIsotropicSpaceHasNoSayInTheDirection) {
  for (const double turn : {0.0, 0.3, 0.7, 1.2}) {
    const TangentSpace mean = metric_mean(std::array{in_plane(0.2, 5, 1), in_plane(turn, 3, 3)});
    expect_same_metric(mean, in_plane(0.2, 4, 2), 1e-14);
  }
}

TEST(MetricMean, OfMagnitudesFarApartIsTheirMean) {
  const TangentSpace mean = metric_mean(std::array{in_plane(0, 1e6, 1), in_plane(0, 1, 1e-6)});
  EXPECT_NEAR(mean.tangent_magnitude, 500000.5, 1e-8);
  EXPECT_NEAR(mean.bitangent_magnitude, 0.5000005, 1e-9);
}

// On a cylinder the directions along and around are parallel to themselves.
TEST(MetricMean, FollowsASurfaceThatBends) {
  const auto on_cylinder = [](double angle, double mirror) {
    return TangentSpace{{0, 0, mirror}, {-std::sin(angle), std::cos(angle), 0}, 2, 7};
  };
  const std::array spaces = {on_cylinder(-0.3, 1), on_cylinder(0.3, -1), on_cylinder(0, 1)};
  expect_same_metric(metric_mean(spaces), on_cylinder(0, 1), 1e-14);
  expect_same_metric(metric_mean(std::array{spaces[0], spaces[1]}), on_cylinder(0, 1), 1e-14);
}

TEST(MetricMean, OfTheSmallestAndLargestMagnitudesIsFinite) {
  const TangentSpace large = in_plane(0.3, largest_coordinate, largest_coordinate);
  const TangentSpace nothing = in_plane(1, 0, 0);
  const TangentSpace line = in_plane(0.5, 3, 0);
  EXPECT_NEAR(metric_mean(std::array{large, nothing, large}).tangent_magnitude / largest_coordinate,
              2.0 / 3, 1e-15);
  expect_same_metric(metric_mean(std::array{nothing, nothing}), nothing, 0);
  expect_same_metric(metric_mean(std::array{line, line}), line, 1e-14);
}

TEST(MetricMean, OfATriangleIsTheSameFromEachCorner) {
  const std::vector spaces = {in_plane(0, 4, 1), in_plane(0.4, 5, 1), in_plane(0.9, 3, 2)};
  const TangentSpace expected = triangle_space({0, 1, 2}, spaces, Averaging::metric);
  expect_same_metric(triangle_space({2, 0, 1}, spaces, Averaging::metric), expected, 1e-14);
  expect_same_metric(triangle_space({1, 0, 2}, spaces, Averaging::metric), expected, 1e-14);
}

TEST(MetricMean, IsByPairsWhereDirectionsSpanNoPlane) {
  const TangentSpace line{{1, 0, 0}, {-1, 0, 0}, 2, 3};
  const TangentSpace none{{0, 0, 0}, {0, 0, 0}, 2, 3};
  for (const TangentSpace& odd : {line, none}) {
    EXPECT_FALSE(has_plane(odd));
    expect_same_metric(average(odd, in_plane(0, 4, 1), Averaging::metric),
                       average(odd, in_plane(0, 4, 1), Averaging::pairwise), 0);
  }
}

}  // namespace
}  // namespace geolloyd
