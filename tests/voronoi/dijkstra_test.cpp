#include "core/voronoi/dijkstra.h"

#include <gtest/gtest.h>

#include "core/voronoi/check_partition.h"
#include "core/voronoi/forest.h"
#include "tests/support/naive.h"
#include "tests/support/random_graph.h"

namespace geolloyd {
namespace {

struct Searched {
  Partition partition;
  std::vector<NodeId> settled;
};

Searched search_free(const Graph& graph, const std::vector<NodeId>& seeds) {
  Searched result;
  IndexedHeap heap(graph.node_count());
  geolloyd::search_free(graph, seeds, heap, result.partition.key, result.settled);
  result.partition.parent.assign(graph.node_count(), no_id);
  derive_parents(graph, result.partition.key, result.settled, result.partition.parent);
  return result;
}

// From one seed alone to every node a seed, on graphs with many ties.
template <class Check>
void for_random_cases(Check&& check) {
  for (std::uint64_t random_seed = 0; random_seed < 300; ++random_seed) {
    const NodeId nodes = 1 + random_number(random_seed, 1000, 30);
    const auto seeds = 1 + random_number(random_seed, 1001, nodes);
    SCOPED_TRACE(random_seed);
    check(random_graph(random_seed, nodes), random_nodes(random_seed + 1000, nodes, seeds));
  }
}

TEST(FreeSearch, AgreesWithBruteForce) {
  for_random_cases([](const Graph& graph, const std::vector<NodeId>& seeds) {
    const Searched result = search_free(graph, seeds);
    const Partition expected = naive::partition(graph, seeds);
    ASSERT_EQ(result.partition.key, expected.key);
    ASSERT_EQ(result.partition.parent, expected.parent);
  });
}

TEST(FreeSearch, SettlesEachReachedNodeOnceInOrderOfKey) {
  for_random_cases([](const Graph& graph, const std::vector<NodeId>& seeds) {
    const Searched result = search_free(graph, seeds);
    const std::vector<Key>& key = result.partition.key;
    for (std::size_t i = 1; i < result.settled.size(); ++i) {
      ASSERT_LE(key[result.settled[i - 1]], key[result.settled[i]]);
    }
    std::vector<int> times(graph.node_count(), 0);
    for (const NodeId v : result.settled) ++times[v];
    for (NodeId v = 0; v < graph.node_count(); ++v)
      ASSERT_EQ(times[v], key[v] != unreached ? 1 : 0);
  });
}

TEST(FreeSearch, IsCertified) {
  for_random_cases([](const Graph& graph, const std::vector<NodeId>& seeds) {
    const auto defect =
        check_partition(graph, seeds, search_free(graph, seeds).partition, Regions::free);
    ASSERT_FALSE(defect.has_value()) << defect->what;
  });
}

TEST(FreeSearch, GivesATieToTheSmallerRegionAndParent) {
  // Seeds at both ends of a row of five: the middle belongs to region 0.
  const Graph row = grid_graph(1, 5);
  EXPECT_EQ(region_of(search_free(row, {0, 4}).partition.key[2]), 0U);
  EXPECT_EQ(region_of(search_free(row, {4, 0}).partition.key[2]), 0U);
  EXPECT_EQ(search_free(row, {4, 0}).partition.parent[2], 3U);
  // The far corner of a square is reached both ways: by way of the smaller node.
  EXPECT_EQ(search_free(grid_graph(2, 2), {3}).partition.parent[0], 1U);
}

TEST(LockedSearch, AgreesWithBruteForceAfterSeedsMoved) {
  for_random_cases([](const Graph& graph, const std::vector<NodeId>& start) {
    Searched result = search_free(graph, start);
    const std::vector<RegionId> regions = naive::regions_of(result.partition);

    // Every second region's seed moves to its largest node; only those are searched again.
    std::vector<NodeId> seeds = start;
    std::vector<RegionId> searched;
    for (RegionId r = 0; r < seeds.size(); r += 2) searched.push_back(r);
    for (NodeId v = 0; v < graph.node_count(); ++v) {
      if (regions[v] != no_id && regions[v] % 2 == 0) seeds[regions[v]] = v;
    }
    IndexedHeap heap(graph.node_count());
    search_locked(graph, seeds, searched, heap, result.partition.key, result.settled);
    derive_parents(graph, result.partition.key, result.settled, result.partition.parent);

    const Partition expected = naive::partition(graph, seeds, regions);
    ASSERT_EQ(result.partition.key, expected.key);
    ASSERT_EQ(result.partition.parent, expected.parent);
    const auto defect = check_partition(graph, seeds, result.partition, Regions::locked);
    ASSERT_FALSE(defect.has_value()) << defect->what;
  });
}

// In a locked region the way may lead back by the seed that made it: longer than any free distance.
TEST(LockedSearch, HasRoomForWaysLongerThanAnyFreeDistance) {
  const Graph graph = make_graph(
      std::vector<UndirectedArc>{
          {0, 1, 1}, {0, 2, 1}, {0, 3, 1}, {0, 4, 0.95}, {1, 2, 1.9}, {1, 3, 1.9}},
      std::vector<double>(5, 1.0));
  Searched result = search_free(graph, {4, 1});
  const std::vector<RegionId> regions = naive::regions_of(result.partition);
  const std::vector<NodeId> seeds = {4, 2};
  ASSERT_EQ(regions[2], 1U);
  IndexedHeap heap(graph.node_count());
  search_locked(graph, seeds, std::vector<RegionId>{0, 1}, heap, result.partition.key,
                result.settled);
  derive_parents(graph, result.partition.key, result.settled, result.partition.parent);
  const auto defect = check_partition(graph, seeds, result.partition, Regions::locked);
  EXPECT_FALSE(defect.has_value()) << defect->what;
  EXPECT_EQ(result.partition.key, naive::partition(graph, seeds, regions).key);
  EXPECT_EQ(result.settled.size(), 5U);
}

TEST(LockedSearch, WithUnmovedSeedsChangesNothing) {
  for_random_cases([](const Graph& graph, const std::vector<NodeId>& seeds) {
    Searched result = search_free(graph, seeds);
    const Partition before = result.partition;
    std::vector<RegionId> all(seeds.size());
    for (RegionId r = 0; r < all.size(); ++r) all[r] = r;
    IndexedHeap heap(graph.node_count());
    search_locked(graph, seeds, all, heap, result.partition.key, result.settled);
    derive_parents(graph, result.partition.key, result.settled, result.partition.parent);
    ASSERT_EQ(result.partition.key, before.key);
    ASSERT_EQ(result.partition.parent, before.parent);
  });
}

}  // namespace
}  // namespace geolloyd
