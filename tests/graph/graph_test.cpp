#include "core/graph/graph.h"

#include <gtest/gtest.h>

#include "core/voronoi/dijkstra.h"
#include "geolloyd/errors.h"
#include "tests/support/random_graph.h"

namespace geolloyd {
namespace {

TEST(Graph, StoresEachLinkAtBothEndsSortedByTarget) {
  //   0 --2-- 1
  //   |       |
  //   1       4
  //   |       |
  //   2 --3-- 3
  const std::vector<UndirectedArc> links = {{3, 1, 4}, {0, 2, 1}, {1, 0, 2}, {3, 2, 3}};
  const Graph graph = make_graph(links, std::vector<double>{1, 1, 1, 1});
  EXPECT_EQ(graph.first_arc, (std::vector<ArcId>{0, 2, 4, 6, 8}));
  EXPECT_EQ(graph.target, (std::vector<NodeId>{1, 2, 0, 3, 0, 3, 1, 2}));
  const double tick = graph.tick_length;
  const std::vector<double> expected = {2, 1, 2, 4, 1, 3, 4, 3};
  for (std::size_t a = 0; a < expected.size(); ++a) {
    EXPECT_NEAR(graph.length[a] * tick, expected[a], tick / 2) << a;
  }
}

TEST(Graph, KeepsTheShortestOfRepeatedLinksAndDropsLoops) {
  const std::vector<UndirectedArc> links = {{0, 1, 5}, {1, 0, 3}, {0, 1, 4}, {1, 1, 1}, {2, 1, 1}};
  const Graph graph = make_graph(links, std::vector<double>{1, 1, 1});
  EXPECT_EQ(graph.target, (std::vector<NodeId>{1, 0, 2, 1}));
  EXPECT_NEAR(graph.length[0] * graph.tick_length, 3, graph.tick_length);
  EXPECT_EQ(graph.length[0], graph.length[1]);
}

TEST(Graph, GivesALinkWithoutLengthOneTick) {
  const Graph graph =
      make_graph(std::vector<UndirectedArc>{{0, 1, 0}, {1, 2, 7}}, std::vector<double>(3, 1.0));
  EXPECT_EQ(graph.length[0], 1U);
  const Graph all_zero =
      make_graph(std::vector<UndirectedArc>{{0, 1, 0}}, std::vector<double>(2, 1.0));
  EXPECT_EQ(all_zero.length, (std::vector<std::uint32_t>{1, 1}));
}

TEST(Graph, ScalesTheLargestMassToThirtyTwoBits) {
  const Graph graph = make_graph({}, std::vector<double>{0, 1, 4, 2});
  EXPECT_EQ(graph.mass[0], 0U);
  EXPECT_EQ(graph.mass[2], 0xffffffffU);
  EXPECT_NEAR(graph.mass[1] * graph.tick_mass, 1, graph.tick_mass);
  const Graph massless = make_graph({}, std::vector<double>{0, 0});
  EXPECT_EQ(massless.mass, (std::vector<std::uint32_t>{0, 0}));
}

TEST(Graph, SurvivesTheSmallestAndLargestNumbers) {
  for (const double scale : {1e-300, 1e-160, 1e-30, 1e30, 1e100}) {
    const Graph graph = make_graph(std::vector<UndirectedArc>{{0, 1, scale}, {1, 2, 2 * scale}},
                                   std::vector<double>{scale, scale, 0});
    EXPECT_GT(graph.length[0], 1000U) << scale;
    EXPECT_GT(graph.mass[0], 1000U) << scale;
  }
}

// The promise on which all distances rest: no shortest path comes near 2^30, whatever the root.
TEST(Graph, KeepsEveryDistanceBelowThirtyBits) {
  for (std::uint64_t random_seed = 0; random_seed < 60; ++random_seed) {
    const Graph graph = random_connected_graph(random_seed, 40);
    IndexedHeap heap(graph.node_count());
    std::vector<Key> keys;
    std::vector<NodeId> settled;
    std::uint32_t farthest = 0;
    for (NodeId root = 0; root < graph.node_count(); ++root) {
      search_free(graph, std::vector<NodeId>{root}, heap, keys, settled);
      farthest = std::max(farthest, distance_of(keys[settled.back()]));
    }
    EXPECT_LT(farthest, 0x40000000U);
    EXPECT_GT(farthest, 40U);
  }
}

TEST(Graph, KeepsALongPathOfTinyLinksBelowThirtyBits) {
  // Lengths of 0 beside one that sets the tick: each costs a whole tick more than it should.
  constexpr NodeId nodes = 100000;
  std::vector<UndirectedArc> links = {{0, 1, 1}};
  for (NodeId v = 1; v + 1 < nodes; ++v) links.push_back({v, v + 1, 0});
  const Graph graph = make_graph(links, std::vector<double>(nodes, 1.0));
  IndexedHeap heap(nodes);
  std::vector<Key> keys;
  std::vector<NodeId> settled;
  search_free(graph, std::vector<NodeId>{0}, heap, keys, settled);
  EXPECT_LT(distance_of(keys[nodes - 1]), 0x40000000U);
  EXPECT_GT(distance_of(keys[nodes - 1]), 0x1fff0000U);
}

TEST(Graph, CutsAnArcThatNoShortestPathCanUse) {
  // A triangle with one side that is absurdly long; the breadth-first tree from 0 does without it.
  const std::vector<UndirectedArc> links = {{0, 1, 1}, {0, 2, 1}, {1, 2, 1e30}};
  const Graph graph = make_graph(links, std::vector<double>(3, 1.0));
  EXPECT_EQ(graph.length[graph.first_arc[2] + 1], 0x40000000U);
  EXPECT_NEAR(graph.length[0], 0x1p29, 200);
}

TEST(Graph, CanBeEmpty) {
  const Graph graph = make_graph({}, {});
  EXPECT_EQ(graph.node_count(), 0U);
  EXPECT_EQ(graph.first_arc, std::vector<ArcId>{0});
}

}  // namespace
}  // namespace geolloyd
