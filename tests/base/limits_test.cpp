#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/graph/graph.h"
#include "core/graph/mesh_graph.h"
#include "core/graph/ticks.h"
#include "core/mesh/subdivide.h"
#include "core/shapes/shapes.h"
#include "core/voronoi/dijkstra.h"
#include "core/voronoi/subtree.h"
#include "geolloyd/errors.h"
#include "tests/support/random_graph.h"

namespace geolloyd {
namespace {

TEST(Limits, OfAMeshAreThoseOfItsIds) {
  EXPECT_EQ(most_vertices, 4'294'967'295U);
  EXPECT_EQ(most_triangles, 1'431'655'765U);
  EXPECT_TRUE(ids_suffice(most_vertices, most_triangles));
  EXPECT_FALSE(ids_suffice(most_vertices + 1, 1));
  EXPECT_FALSE(ids_suffice(1, most_triangles + 1));
}

TEST(Limits, OfAGraphAreHeldToTheLastNodeAndArc) {
  EXPECT_EQ(most_nodes, 1'073'741'823U);
  EXPECT_EQ(most_arcs, 4'294'967'294U);
  EXPECT_NO_THROW(check_node_count(most_nodes));
  EXPECT_THROW(check_node_count(most_nodes + 1), InvalidInput);
  EXPECT_NO_THROW(check_arc_count(most_arcs / 2));
  EXPECT_THROW(check_arc_count(most_arcs / 2 + 1), InvalidInput);
  EXPECT_THROW(check_arc_count(std::numeric_limits<std::uint64_t>::max()), InvalidInput);
}

// Before memory is taken: at these sizes a test that took it would not come back.
TEST(Limits, OfIdsStopGeneratorsAndSubdivisions) {
  for (const auto shape : {creature, irregular_plane, torus, cylinder}) {
    EXPECT_THROW(shape(most_triangles + 1, 1), InvalidInput);
    EXPECT_THROW(shape(std::numeric_limits<std::size_t>::max(), 1), InvalidInput);
  }
  EXPECT_THROW(icosphere(1'000'000'000'000), InvalidInput);
  const Mesh mesh = icosphere(20);
  EXPECT_THROW(refine(mesh, 8461), InvalidInput);  // 20 * 8461^2 is 30,655 over the limit
  EXPECT_THROW(refine(mesh, std::numeric_limits<std::uint32_t>::max()), InvalidInput);
}

TEST(TickLength, HasALimitOfArcsOnAPath) {
  EXPECT_EQ(most_path_arcs, 268'435'424U);
  EXPECT_GT(tick_length_for({1, most_path_arcs}), 0);
  EXPECT_GT(tick_length_for({0, most_path_arcs}), 0);
  EXPECT_THROW(tick_length_for({1, most_path_arcs + 1}), InvalidInput);
  EXPECT_THROW(tick_length_for({0, most_path_arcs + 1}), InvalidInput);
}

// The most ticks that the two ways to the root can have: each arc a whole tick more than its
// length.
TEST(TickLength, KeepsTheLongestPathBelowTheLimitHoweverManyArcs) {
  for (const double length : {1e-310, 1e-30, 1.0, 3.7, 1e300}) {
    for (const std::size_t arcs : {std::size_t{1}, std::size_t{1000}, most_path_arcs}) {
      const double tick = tick_length_for({length, arcs});
      const double ticks = 2 * length / tick + 2 * static_cast<double>(arcs);
      EXPECT_LT(ticks, most_length) << length << " " << arcs;
      EXPECT_GT(ticks, length > 1e-300 ? most_length - 100 : 0) << length << " " << arcs;
    }
  }
}

TEST(TickLength, IsRefusedWhereLengthsAddUpToNoNumber) {
  const std::vector<UndirectedArc> links = {{0, 1, 1e308}, {1, 2, 1e308}};
  EXPECT_THROW(make_graph(links, std::vector<double>(3, 1.0)), InvalidInput);
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_THROW(make_graph({}, std::vector<double>{1, infinite}), InvalidInput);
}

std::vector<Key> distances_from(const Graph& graph, NodeId source) {
  IndexedHeap heap(graph.node_count());
  std::vector<Key> keys;
  std::vector<NodeId> settled;
  search_free(graph, std::vector<NodeId>{source}, heap, keys, settled);
  return keys;
}

std::uint32_t farthest_of(const std::vector<Key>& keys) {
  std::uint32_t most = 0;
  for (const Key key : keys) most = std::max(most, distance_of(key));
  return most;
}

// Two arms of as many arcs from node 0, odd nodes on one, even ones on the other.
std::vector<UndirectedArc> two_arms(NodeId nodes, const auto& length_of) {
  std::vector<UndirectedArc> links;
  for (NodeId v = 1; v < nodes; ++v) links.push_back({v < 3 ? 0 : v - 2, v, length_of(v)});
  return links;
}

// From one end to the other it is as long as a path can be.
TEST(TickLength, IsReachedByAPathOfHundredsOfThousandsOfArcs) {
  constexpr NodeId nodes = 400'001;
  const std::vector<double> masses(nodes, 2.5);
  const Graph even = make_graph(two_arms(nodes, [](NodeId) { return 1.0; }), masses);
  const std::uint32_t far = farthest_of(distances_from(even, nodes - 1));
  EXPECT_LT(far, most_length);
  EXPECT_GT(far, most_length - 2 * nodes);

  // One enormous arc on each arm, and all others too short for a tick: each costs one.
  const Graph uneven =
      make_graph(two_arms(nodes, [](NodeId v) { return v < 3 ? 1e9 : 1e-9; }), masses);
  EXPECT_EQ(uneven.length[uneven.first_arc[nodes - 1]], 1U);
  EXPECT_LT(farthest_of(distances_from(uneven, nodes - 1)), most_length);
  EXPECT_GT(farthest_of(distances_from(uneven, nodes - 1)), most_length - 100);

  // Sums over its one long tree: every node but the first hangs from the one before.
  const Graph& graph = uneven;
  Partition partition{distances_from(graph, nodes - 1), {}};
  std::vector<NodeId> order(nodes);
  for (NodeId v = 0; v < nodes; ++v) order[v] = v;
  std::sort(order.begin(), order.end(),
            [&](NodeId a, NodeId b) { return partition.key[a] < partition.key[b]; });
  partition.parent.assign(nodes, no_id);
  for (std::size_t i = 1; i < nodes; ++i) partition.parent[order[i]] = order[i - 1];
  SubtreeSums sums{std::vector<std::uint64_t>(nodes), std::vector<std::uint64_t>(nodes)};
  sum_subtrees(graph, partition, order, sums);
  Uint128 cost = 0;
  for (const Key key : partition.key) cost += distance_of(key);
  EXPECT_TRUE(sums.cost[nodes - 1] == cost);
  EXPECT_EQ(sums.mass[nodes - 1], std::uint64_t{most_mass} * nodes);
}

TEST(TickLength, OfAStarIsForTheLongestTwoOfItsArcs) {
  constexpr NodeId leaves = 1'000'000;
  std::vector<UndirectedArc> links;
  for (NodeId v = 1; v <= leaves; ++v) links.push_back({0, v, v % 2 == 0 ? 0.0 : 8.0});
  const Graph graph = make_graph(links, std::vector<double>(leaves + 1, 1.0));
  EXPECT_EQ(graph.neighbours(0).size(), leaves);
  const std::uint32_t far = farthest_of(distances_from(graph, 1));
  EXPECT_LT(far, most_length);
  EXPECT_GT(far, most_length - 100);
}

// Regions are locked as a free partition has them, and then searched from any of their nodes.
TEST(TickLength, BoundsDistancesFreeAndLocked) {
  std::uint32_t farthest_locked = 0;
  for (std::uint64_t random_seed = 0; random_seed < 300; ++random_seed) {
    const Graph graph = random_connected_graph(random_seed, 30);
    IndexedHeap heap(graph.node_count());
    std::vector<Key> free_keys;
    std::vector<NodeId> settled;
    const std::vector<NodeId> seeds = random_nodes(random_seed, 30, 3);
    search_free(graph, seeds, heap, free_keys, settled);
    ASSERT_LT(farthest_of(free_keys), most_length);
    const std::vector<RegionId> all = {0, 1, 2};
    for (NodeId offset = 0; offset < 30; ++offset) {
      std::vector<NodeId> moved = seeds;
      for (NodeId v = 0; v < 30; ++v) {
        if (v >= offset) moved[region_of(free_keys[v])] = v;
      }
      std::vector<Key> keys = free_keys;
      search_locked(graph, moved, all, heap, keys, settled);
      ASSERT_EQ(settled.size(), 30U);
      farthest_locked = std::max(farthest_locked, farthest_of(keys));
    }
  }
  EXPECT_LT(farthest_locked, most_distance);
  EXPECT_GT(farthest_locked, most_length / 2);
}

}  // namespace
}  // namespace geolloyd
