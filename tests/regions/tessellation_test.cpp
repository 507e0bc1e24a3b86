#include "core/regions/tessellation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "tests/support/naive.h"
#include "tests/support/random_graph.h"

namespace geolloyd {
namespace {

TEST(Tessellation, SumsUpItsRegions) {
  // A row of five, seeds at the ends: three nodes and two.
  const Graph graph = grid_graph(1, 5);
  const std::vector<NodeId> seeds = {0, 4};
  const Partition partition = naive::partition(graph, seeds);
  const std::vector<Score> scores = {naive::score(graph, partition, 0),
                                     naive::score(graph, partition, 1)};
  const auto regions = summarise_regions(graph, partition, seeds, scores);
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[0].node_count, 3U);
  EXPECT_EQ(regions[1].node_count, 2U);
  EXPECT_EQ(regions[1].seed, 4U);
  EXPECT_NEAR(regions[0].area, 3, 1e-6);
  EXPECT_NEAR(regions[0].energy, 5, 1e-6);
  EXPECT_NEAR(regions[1].energy, 1, 1e-6);
  using Pairs = std::vector<std::pair<RegionId, RegionId>>;
  EXPECT_EQ(adjacent_regions(graph, partition), (Pairs{{0, 1}}));
}

TEST(Tessellation, KnowsHowEvenItsRegionsAre) {
  std::vector<RegionSummary> regions(4);
  for (RegionSummary& region : regions) region.area = 7;
  RegionSpread spread = region_spread(regions);
  EXPECT_DOUBLE_EQ(spread.deviation, 0);
  EXPECT_DOUBLE_EQ(spread.smallest, 1);
  EXPECT_DOUBLE_EQ(spread.largest, 1);
  regions[0].area = 1;  // with 13, 7, 7: mean 7, variance 18
  regions[3].area = 13;
  spread = region_spread(regions);
  EXPECT_DOUBLE_EQ(spread.deviation, std::sqrt(18.0) / 7);
  EXPECT_DOUBLE_EQ(spread.smallest, 1.0 / 7);
  EXPECT_DOUBLE_EQ(spread.largest, 13.0 / 7);
  EXPECT_TRUE(std::isnan(region_spread(std::vector<RegionSummary>(2)).deviation));
}

TEST(Tessellation, GivesAdjacentRegionsDifferentColours) {
  for (std::uint64_t random_seed = 0; random_seed < 30; ++random_seed) {
    std::vector<std::pair<RegionId, RegionId>> adjacent;
    for (std::uint64_t i = 0; i < 200; ++i) {
      const auto a = random_number(random_seed, 2 * i, 50);
      const auto b = random_number(random_seed, 2 * i + 1, 50);
      if (a != b) adjacent.emplace_back(std::min(a, b), std::max(a, b));
    }
    const auto colour = colour_regions(50, adjacent, 4);
    for (const auto& [a, b] : adjacent) EXPECT_NE(colour[a], colour[b]);
  }
}

TEST(Tessellation, KeepsToThePreferredColoursOnASurfaceAndUsesThemAll) {
  const Graph graph = grid_graph(40, 40);
  const Partition partition = naive::partition(graph, random_nodes(1, 1600, 200));
  std::vector<int> uses(8, 0);
  for (const std::uint32_t c : colour_regions(200, adjacent_regions(graph, partition), 8)) {
    ASSERT_LT(c, 8U);
    ++uses[c];
  }
  for (const int u : uses) EXPECT_GT(u, 10);
}

TEST(Tessellation, TakesMoreColoursWhereAllRegionsTouch) {
  std::vector<std::pair<RegionId, RegionId>> adjacent;
  for (RegionId a = 0; a < 12; ++a) {
    for (RegionId b = a + 1; b < 12; ++b) adjacent.emplace_back(a, b);
  }
  std::vector<std::uint32_t> colour = colour_regions(12, adjacent, 8);
  std::sort(colour.begin(), colour.end());
  for (std::uint32_t i = 0; i < 12; ++i) EXPECT_EQ(colour[i], i);
}

}  // namespace
}  // namespace geolloyd
