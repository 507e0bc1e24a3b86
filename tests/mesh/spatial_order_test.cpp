#include "core/mesh/spatial_order.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/random.h"

namespace geolloyd {
namespace {

TEST(SpatialOrder, IsTheZCurveOnAGrid) {
  const std::vector<Vec3> corners = {{1, 1, 1}, {0, 0, 1}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(spatial_order(corners), (std::vector<std::uint32_t>{3, 1, 2, 4, 0}));
}

TEST(SpatialOrder, IsAPermutationThatKeepsNeighboursNear) {
  std::vector<Vec3> points;
  for (std::uint64_t i = 0; i < 4096; ++i) {
    points.emplace_back(random_unit(1, 2 * i), random_unit(1, 2 * i + 1), 0);
  }
  std::vector<std::uint32_t> order = spatial_order(points);
  double walk = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    walk += (points[order[i]] - points[order[i - 1]]).norm();
  }
  EXPECT_LT(walk / 4096, 0.05);  // 0.52 in random order
  std::sort(order.begin(), order.end());
  for (std::uint32_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
}

TEST(SpatialOrder, KeepsIndicesInOrderAtOnePlaceAndStandsAnySize) {
  EXPECT_EQ(spatial_order(std::vector<Vec3>(3, Vec3(2, 2, 2))),
            (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_TRUE(spatial_order({}).empty());
  const std::vector<Vec3> huge = {{1e75, 0, 0}, {-1e75, 0, 0}};
  EXPECT_EQ(spatial_order(huge), (std::vector<std::uint32_t>{1, 0}));
  const std::vector<Vec3> tiny = {{1e-300, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(spatial_order(tiny), (std::vector<std::uint32_t>{1, 0}));
}

}  // namespace
}  // namespace geolloyd
