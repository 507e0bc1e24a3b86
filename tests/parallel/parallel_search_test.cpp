// The searches of the parallel engine, each on its own, against Dijkstra's.
#include <gtest/gtest.h>

#include <numeric>

#include "core/voronoi/check_partition.h"
#include "core/voronoi/dijkstra.h"
#include "core/voronoi/forest.h"
#include "parallel/engine/delta_stepping.h"
#include "parallel/engine/large_region_search.h"
#include "parallel/engine/neighbour_subtrees.h"
#include "parallel/engine/region_nodes.h"
#include "parallel/engine/simd_search.h"
#include "tests/support/random_graph.h"

namespace geolloyd {
namespace {

Partition partition_by_dijkstra(const Graph& graph, const std::vector<NodeId>& seeds) {
  Partition result;
  IndexedHeap heap(graph.node_count());
  std::vector<NodeId> settled;
  search_free(graph, seeds, heap, result.key, settled);
  result.parent.assign(graph.node_count(), no_id);
  derive_parents(graph, result.key, settled, result.parent);
  return result;
}

std::vector<NodeId> all_nodes(const Graph& graph) {
  std::vector<NodeId> nodes(graph.node_count());
  std::iota(nodes.begin(), nodes.end(), NodeId{0});
  return nodes;
}

TEST(DeltaStepping, FindsTheSameForAnyWidthOfBuckets) {
  Scheduler scheduler(3);
  for (std::uint64_t random_seed = 0; random_seed < 60; ++random_seed) {
    const Graph graph = random_graph(random_seed, 200);
    const auto seeds = random_nodes(random_seed, 200, 1 + random_seed % 9);
    const std::vector<Key> expected = partition_by_dijkstra(graph, seeds).key;
    for (const std::uint32_t delta : {0U, 1U << 18, 1U << 22, 1U << 26, 1U << 30}) {
      std::vector<Key> keys;
      DeltaStepping(scheduler, graph, delta).search(seeds, keys);
      ASSERT_EQ(keys, expected) << random_seed << ", delta " << delta;
    }
  }
}

TEST(DeltaStepping, RepairsAnyUpperBounds) {
  Scheduler scheduler(3);
  for (std::uint64_t random_seed = 0; random_seed < 60; ++random_seed) {
    const Graph graph = random_connected_graph(random_seed, 150);
    const auto seeds = random_nodes(random_seed, 150, 5);
    const std::vector<Key> expected = partition_by_dijkstra(graph, seeds).key;
    std::vector<Key> keys = expected;
    for (NodeId v = 0; v < keys.size(); ++v) {
      if (distance_of(keys[v]) > 0)
        keys[v] = along(keys[v], random_number(random_seed, v, 1 << 28));
    }
    RegionNodes members;
    find_region_nodes(scheduler, keys, seeds.size(), members);
    std::vector<RegionId> regions(seeds.size());
    std::iota(regions.begin(), regions.end(), RegionId{0});
    std::vector<std::uint8_t> is_changed(seeds.size(), 0);
    DeltaStepping(scheduler, graph)
        .repair(members, cut_into_slices(members, regions), keys, is_changed);
    ASSERT_EQ(keys, expected) << random_seed;
  }
}

TEST(DeltaStepping, TellsWhichRegionsChanged) {
  Scheduler scheduler(2);
  const Graph graph = grid_graph(1, 30);  // a row: regions are runs of nodes
  const std::vector<NodeId> seeds = {2, 12, 27};
  std::vector<Key> keys = partition_by_dijkstra(graph, seeds).key;
  RegionNodes members;
  find_region_nodes(scheduler, keys, 3, members);
  keys[9] = along(keys[9], 5);
  const std::vector<RegionId> suspects = {1};
  std::vector<std::uint8_t> is_changed(3, 0);
  DeltaStepping(scheduler, graph)
      .repair(members, cut_into_slices(members, suspects), keys, is_changed);
  EXPECT_EQ(is_changed, (std::vector<std::uint8_t>{0, 1, 0}));
}

TEST(RegionNodes, AreTheNodesOfEachRegionAscending) {
  for (const std::size_t threads : {1U, 2U, 5U}) {
    Scheduler scheduler(threads);
    const Graph graph = random_graph(3, 300);
    const auto seeds = random_nodes(3, 300, 20);
    const std::vector<Key> keys = partition_by_dijkstra(graph, seeds).key;
    RegionNodes members;
    find_region_nodes(scheduler, keys, seeds.size(), members);
    std::size_t listed = 0;
    for (RegionId r = 0; r < seeds.size(); ++r) {
      const auto nodes = members.of(r);
      EXPECT_TRUE(std::is_sorted(nodes.begin(), nodes.end()));
      for (const NodeId v : nodes) EXPECT_EQ(region_of(keys[v]), r);
      listed += nodes.size();
    }
    EXPECT_EQ(listed, keys.size() - static_cast<std::size_t>(
                                        std::count(keys.begin(), keys.end(), unreached)));
  }
}

TEST(RegionNodes, LargeRegionsAreCut) {
  RegionNodes members;
  members.first = {0, 3, 10000, 10000};
  members.node.resize(10000);
  const std::vector<RegionId> regions = {1, 2, 0};
  const std::vector<RegionSlice> slices = cut_into_slices(members, regions);
  ASSERT_EQ(slices.size(), 4U);
  NodeId next = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(slices[i].region, 1U);
    EXPECT_EQ(slices[i].begin, next);
    next = slices[i].end;
  }
  EXPECT_EQ(next, 10000U);
  EXPECT_EQ(slices[3].region, 0U);
  EXPECT_EQ(slices[3].end, 3U);
}

// Around each node of a graph, with itself as the only seed.
template <class Check>
void for_stands(Check&& check) {
  for (std::uint64_t random_seed = 0; random_seed < 40; ++random_seed) {
    SCOPED_TRACE(random_seed);
    const NodeId nodes = 2 + random_number(random_seed, 77, 60);
    const Graph graph = random_connected_graph(random_seed, nodes);
    const NodeId stand = random_number(random_seed, 78, nodes);
    check(graph, stand, partition_by_dijkstra(graph, {stand}));
    if (testing::Test::HasFatalFailure()) return;
  }
}

struct StandBranches {
  BranchOf branch_of;
  SubtreeSums sums;

  StandBranches(const Graph& graph, NodeId stand, const Partition& partition)
      : branch_of(graph.node_count()),
        sums{std::vector<std::uint64_t>(graph.node_count()),
             std::vector<std::uint64_t>(graph.node_count())} {
    const auto nodes = all_nodes(graph);
    std::vector<BranchSum> room;
    find_branches(graph, partition, stand, nodes, branch_of, room, sums);
  }
};

TEST(Branches, SumToTheSubtreesOfTheSeedsNeighbours) {
  for_stands([](const Graph& graph, NodeId stand, const Partition& partition) {
    const StandBranches branches(graph, stand, partition);
    std::vector<NodeId> by_distance = all_nodes(graph);
    std::sort(by_distance.begin(), by_distance.end(),
              [&](NodeId a, NodeId b) { return partition.key[a] < partition.key[b]; });
    SubtreeSums expected = branches.sums;
    sum_subtrees(graph, partition, by_distance, expected);
    for (const NodeId v : graph.neighbours(stand)) {
      ASSERT_EQ(branches.sums.cost[v], expected.cost[v]);
      ASSERT_EQ(branches.sums.mass[v], expected.mass[v]);
    }
  });
}

TEST(Branches, BelowANeighbourIsWhatHasItAmongItsAncestors) {
  for_stands([](const Graph& graph, NodeId stand, const Partition& partition) {
    const StandBranches branches(graph, stand, partition);
    for (const NodeId top : graph.neighbours(stand)) {
      std::vector<std::uint8_t> below;
      find_branches_below(graph, partition, stand, branches.branch_of, top, below);
      for (NodeId v = 0; v < graph.node_count(); ++v) {
        NodeId ancestor = v;
        while (ancestor != top && ancestor != no_id) ancestor = partition.parent[ancestor];
        const std::uint32_t branch = branches.branch_of[v];
        ASSERT_EQ(branch < below.size() && below[branch] != 0, ancestor == top);
      }
    }
  });
}

Score score_from(const Graph& graph, NodeId source) {
  Score score = 0;
  const Partition partition = partition_by_dijkstra(graph, {source});
  for (NodeId v = 0; v < graph.node_count(); ++v) {
    score += node_score(distance_of(partition.key[v]), graph.mass[v]);
  }
  return score;
}

// From any nodes, neighbours of the stand or not, given bounds that are merely not too low.
TEST(SimdSearch, FindsDistancesAndScoresOfAllItsSources) {
  SimdSearch lanes;
  for_stands([&](const Graph& graph, NodeId stand, const Partition& partition) {
    const StandBranches branches(graph, stand, partition);
    const auto nodes = static_cast<NodeId>(graph.node_count());
    const std::vector<NodeId> sources =
        random_nodes(nodes, nodes, std::min<NodeId>(SimdSearch::lanes, nodes));
    std::vector<SimdSearch::Lanes> offset(1);
    for (std::size_t j = 0; j < SimdSearch::lanes; ++j) {
      offset[0].d[j] = distance_of(partition.key[sources[j % sources.size()]]);
    }
    lanes.run(graph, sources, {partition.key, branches.branch_of, offset}, all_nodes(graph));
    const auto scores = lanes.scores(graph);
    for (std::size_t j = 0; j < sources.size(); ++j) {
      const Partition expected = partition_by_dijkstra(graph, {sources[j]});
      for (NodeId v = 0; v < nodes; ++v) {
        ASSERT_EQ(lanes.distance(v, j), distance_of(expected.key[v]));
      }
      ASSERT_EQ(scores[j], score_from(graph, sources[j]));
    }
  });
}

// Two links of the longest length in a row, with the greatest mass at both ends: sums of 95 bits.
TEST(SimdSearch, ScoresAreExactAtTheLimits) {
  Graph graph;
  graph.first_arc = {0, 1, 3, 4};
  graph.target = {1, 0, 2, 1};
  graph.length = {(1U << 30) - 1, (1U << 30) - 1, (1U << 30) - 1, (1U << 30) - 1};
  graph.mass = {~0U, ~0U, ~0U};
  const std::vector<NodeId> sources = {0};
  const Partition partition = partition_by_dijkstra(graph, {0});
  SimdSearch lanes;
  const std::vector<SimdSearch::Lanes> offset(1, SimdSearch::Lanes{});
  const std::vector<std::uint32_t> branch_of(3, 0);
  lanes.run(graph, sources, {partition.key, branch_of, offset}, all_nodes(graph));
  EXPECT_EQ(lanes.distance(2, 0), 2 * ((1U << 30) - 1));
  EXPECT_EQ(lanes.scores(graph)[0], score_from(graph, 0));
}

// From the other end of the longest ways to a source two arcs away: bounds beyond 32 bits.
TEST(LargeRegionSearch, KeepsToItsLimits) {
  Graph graph;
  constexpr std::uint32_t longest = (1U << 30) - 1;
  graph.first_arc = {0, 1, 3, 4};
  graph.target = {1, 0, 2, 1};
  graph.length = {longest, longest, longest, longest};
  graph.mass = {1, 1, 1};
  const Partition partition = partition_by_dijkstra(graph, {0});
  const StandBranches branches(graph, 0, partition);
  Scheduler scheduler(2);
  LargeRegionSearch search(scheduler, graph);
  search.run(partition, 0, branches.branch_of, 2);
  EXPECT_EQ(search.score(), score_from(graph, 2));
}

TEST(LargeRegionSearch, FindsDistancesAndScoresFromNodeToNode) {
  Scheduler scheduler(3);
  for_stands([&](const Graph& graph, NodeId stand, const Partition& partition) {
    const StandBranches branches(graph, stand, partition);
    LargeRegionSearch search(scheduler, graph);
    for (NodeId source = 0; source < graph.node_count(); ++source) {
      search.run(partition, stand, branches.branch_of, source);
      ASSERT_EQ(search.source(), source);
      ASSERT_EQ(search.score(), score_from(graph, source));
      std::vector<Key> keys(graph.node_count());
      search.swap_keys(keys);
      ASSERT_EQ(keys, partition_by_dijkstra(graph, {source}).key);
      search.swap_keys(keys);
    }
  });
}

}  // namespace
}  // namespace geolloyd
