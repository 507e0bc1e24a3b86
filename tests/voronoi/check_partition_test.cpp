#include "core/voronoi/check_partition.h"

#include <gtest/gtest.h>

#include "tests/support/naive.h"
#include "tests/support/random_graph.h"

namespace geolloyd {
namespace {

TEST(CheckPartition, AcceptsTheTruth) {
  for (std::uint64_t random_seed = 0; random_seed < 100; ++random_seed) {
    const Graph graph = random_graph(random_seed, 25);
    const std::vector<NodeId> seeds = random_nodes(random_seed, 25, 1 + random_seed % 25);
    const Partition truth = naive::partition(graph, seeds);
    EXPECT_FALSE(check_partition(graph, seeds, truth, Regions::free).has_value());
    EXPECT_FALSE(check_partition(graph, seeds, truth, Regions::locked).has_value());
  }
}

// Whatever single entry is changed, and to whatever plausible value, is found out.
TEST(CheckPartition, RefusesEveryChangeOfAnEntry) {
  int changes = 0;
  for (std::uint64_t random_seed = 0; random_seed < 200; ++random_seed) {
    const NodeId nodes = 12;
    const Graph graph = random_graph(random_seed, nodes);
    const std::vector<NodeId> seeds = random_nodes(random_seed, nodes, 1 + random_seed % 5);
    const Partition truth = naive::partition(graph, seeds);
    for (NodeId v = 0; v < nodes; ++v) {
      const std::uint32_t distance = distance_of(truth.key[v]);
      const RegionId region = region_of(truth.key[v]);
      const std::vector<Key> wrong_keys = {
          make_key(distance + 1, region), make_key(distance - 1, region), make_key(0, region),
          make_key(distance, region + 1), make_key(distance, 0),          unreached};
      for (const Key key : wrong_keys) {
        if (key == truth.key[v]) continue;
        Partition wrong = truth;
        wrong.key[v] = key;
        EXPECT_TRUE(check_partition(graph, seeds, wrong, Regions::free).has_value());
        ++changes;
      }
      for (NodeId parent = 0; parent <= nodes; ++parent) {
        Partition wrong = truth;
        wrong.parent[v] = parent == nodes ? no_id : parent;
        if (wrong.parent[v] == truth.parent[v]) continue;
        EXPECT_TRUE(check_partition(graph, seeds, wrong, Regions::free).has_value());
        EXPECT_TRUE(check_partition(graph, seeds, wrong, Regions::locked).has_value());
        ++changes;
      }
    }
  }
  EXPECT_GT(changes, 20000);
}

TEST(CheckPartition, RefusesConsistentDistancesThatAreTooLong) {
  // On a row of three with the seed at 0 every arc is tight, but everything is one tick too far.
  const Graph graph = grid_graph(1, 3);
  Partition wrong = naive::partition(graph, {0});
  wrong.key[1] += Key{1} << 32;
  wrong.key[2] += Key{1} << 32;
  EXPECT_TRUE(check_partition(graph, std::vector<NodeId>{0}, wrong, Regions::free).has_value());
}

TEST(CheckPartition, RefusesTheWrongSize) {
  const Graph graph = grid_graph(2, 2);
  EXPECT_TRUE(check_partition(graph, std::vector<NodeId>{0}, {}, Regions::free).has_value());
}

}  // namespace
}  // namespace geolloyd
