// Distances, masses, degrees and numbers of seeds as large as they can be: both engines, and all
// ways to search.
#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "core/lloyd/paired_engine.h"
#include "core/voronoi/dijkstra.h"
#include "tests/support/agreement.h"
#include "tests/support/random_graph.h"

namespace geolloyd {
namespace {

void expect_agreement(const Graph& graph, const std::vector<NodeId>& seeds,
                      const RelaxationOptions& options) {
  Scheduler scheduler(2);
  const Relaxation expected = relax_by_reference(graph, seeds, options);
  for (const Frontier frontier : all_frontiers) {
    expect_same(expected, relax_in_parallel(scheduler, frontier, graph, seeds, options));
  }
}

// The region of node 1 holds 3 and 4, each nearly two depths of the tree away, and all other ways
// between these lead by node 0, which belongs to the seed 2:
//
//           2 --D-- 0 --D-- 1
//                  / \     / \         From 1 to 3, and to 4, it is 2 D: by way of 0, or straight.
//                 3   4   3   4
//
// At 3 and at 4 hangs a tail of nodes in one place.
constexpr double depth = 1e6;

Graph detour_graph(NodeId tail) {
  std::vector<UndirectedArc> links = {{0, 1, depth}, {0, 2, depth - 1},     {0, 3, depth},
                                      {0, 4, depth}, {1, 3, 2 * depth - 3}, {1, 4, 2 * depth - 3}};
  for (NodeId v = 5; v < 5 + 2 * tail; ++v) links.push_back({v - 2, v, 0});
  return make_graph(links, std::vector<double>(5 + 2 * tail, 1.0));
}

TEST(Farthest, DistanceInALockedRegionIsNearlyTwiceTheFarthestFreeOne) {
  const Graph graph = detour_graph(0);
  IndexedHeap heap(graph.node_count());
  std::vector<Key> keys;
  std::vector<NodeId> settled;
  search_free(graph, std::vector<NodeId>{1, 2}, heap, keys, settled);
  ASSERT_EQ(region_of(keys[0]), 1U);
  ASSERT_EQ(region_of(keys[3]), 0U);
  ASSERT_EQ(region_of(keys[4]), 0U);
  EXPECT_LT(distance_of(keys[3]), most_length);
  EXPECT_GT(distance_of(keys[3]), most_length - 4000);
  search_locked(graph, std::vector<NodeId>{3, 2}, std::vector<RegionId>{0, 1}, heap, keys, settled);
  EXPECT_LT(distance_of(keys[4]), most_distance);
  EXPECT_GT(distance_of(keys[4]), most_distance - 4000);
}

// In lanes, which is how regions of few nodes are searched.
TEST(Farthest, DistancesInLockedRegionsAreFoundByAllEngines) {
  for (const NodeId tail : {0U, 5U}) {
    const Graph graph = detour_graph(tail);
    for (const GreedyMode greedy : {GreedyMode::off, GreedyMode::extended}) {
      RelaxationOptions options;
      options.greedy = greedy;
      expect_agreement(graph, {1, 2}, options);
      expect_agreement(graph, {3, 2}, options);
    }
  }
}

// By all threads. The seed looks at both ends of the way, finds them no better, and stays.
TEST(Farthest, DistancesInLargeLockedRegionsAreFoundByAllEngines) {
  RelaxationOptions options;
  options.greedy = GreedyMode::off;
  expect_agreement(detour_graph(20'000), {1, 2}, options);
}

TEST(Farthest, NumberOfSeedsIsThatOfTheNodes) {
  const Graph graph = random_connected_graph(7, 500);
  std::vector<NodeId> seeds(graph.node_count());
  std::iota(seeds.rbegin(), seeds.rend(), NodeId{0});
  const Relaxation result = relax_by_reference(graph, seeds, {});
  EXPECT_EQ(result.stop_reason, StopReason::converged);
  EXPECT_EQ(result.seeds, seeds);
  expect_agreement(graph, seeds, {});
}

std::vector<UndirectedArc> star(NodeId leaves) {
  std::vector<UndirectedArc> links;
  for (NodeId v = 1; v <= leaves; ++v) links.push_back({0, v, 1.0 + v % 7});
  return links;
}

TEST(Farthest, RelaxationOfAStarAgrees) {
  const Graph graph = make_graph(star(300), std::vector<double>(301, 1.0));
  expect_agreement(graph, {5, 17}, {});
  expect_agreement(graph, {0, 17}, {});
}

TEST(Farthest, DegreeOfAMillionAgrees) {
  constexpr NodeId leaves = 1'000'000;
  const Graph graph = make_graph(star(leaves), std::vector<double>(leaves + 1, 1.0));
  Scheduler scheduler(2);
  const auto reference = make_reference_engine(graph);
  for (const Frontier frontier : {Frontier::delta, Frontier::regions}) {
    const auto parallel = make_parallel_engine(scheduler, graph, frontier);
    PairedEngine pair(*reference, *parallel);
    for (const std::vector<NodeId>& seeds : {std::vector<NodeId>{0, 9}, {8, 9}, {8, 10}}) {
      pair.partition(seeds);
      EXPECT_EQ(pair.greedy_candidates(seeds, true).size(), 2U);
    }
  }
}

}  // namespace
}  // namespace geolloyd
