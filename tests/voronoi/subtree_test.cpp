#include "core/voronoi/subtree.h"

#include <gtest/gtest.h>

#include "core/voronoi/dijkstra.h"
#include "core/voronoi/energy.h"
#include "tests/support/naive.h"
#include "tests/support/random_graph.h"

namespace geolloyd {
namespace {

TEST(SubtreeSums, AndScoresAgreeWithBruteForce) {
  for (std::uint64_t random_seed = 0; random_seed < 150; ++random_seed) {
    SCOPED_TRACE(random_seed);
    const Graph graph = random_graph(random_seed, 24);
    const std::vector<NodeId> seeds = random_nodes(random_seed, 24, 1 + random_seed % 6);
    IndexedHeap heap(24);
    Partition partition = naive::partition(graph, seeds);
    std::vector<NodeId> settled;
    search_free(graph, seeds, heap, partition.key, settled);

    SubtreeSums sums{std::vector<std::uint64_t>(24), std::vector<std::uint64_t>(24)};
    sum_subtrees(graph, partition, settled, sums);
    for (const NodeId v : settled) {
      const naive::Sums expected = naive::subtree(graph, partition, v);
      ASSERT_EQ(sums.cost[v], expected.cost);
      ASSERT_EQ(sums.mass[v], expected.mass);
    }

    std::vector<Score> scores(seeds.size(), 0);
    add_scores(graph, partition.key, settled, scores);
    for (RegionId r = 0; r < seeds.size(); ++r) {
      ASSERT_EQ(scores[r], naive::score(graph, partition, r));
    }
  }
}

TEST(SubtreeSums, OfARowHoldsTheWholeRow) {
  // Masses 1 and unit arcs, seed at the left end: distances 0 1 2 3.
  const Graph graph = grid_graph(1, 4);
  const Partition partition = naive::partition(graph, {0});
  SubtreeSums sums{std::vector<std::uint64_t>(4), std::vector<std::uint64_t>(4)};
  sum_subtrees(graph, partition, std::vector<NodeId>{0, 1, 2, 3}, sums);
  const std::uint64_t unit = graph.length[0];
  EXPECT_EQ(sums.cost[0], 6 * unit);
  EXPECT_EQ(sums.cost[2], 5 * unit);
  EXPECT_EQ(sums.mass[1], 3 * std::uint64_t{graph.mass[0]});
}

TEST(Score, OfTheLargestDistancesAndMassesDoesNotOverflow) {
  Graph graph = grid_graph(1, 3);
  for (std::uint32_t& length : graph.length) length = 0x3fffffff;
  const std::vector<Key> keys = {make_key(0, 0), make_key(0x3fffffff, 0), make_key(0x7ffffffe, 0)};
  std::vector<Score> score(1, 0);
  add_scores(graph, keys, std::vector<NodeId>{0, 1, 2}, score);
  const double expected = (0x1p60 + 0x1p62) * 0x1p32;
  EXPECT_NEAR(static_cast<double>(score[0]) / expected, 1, 1e-8);
}

}  // namespace
}  // namespace geolloyd
