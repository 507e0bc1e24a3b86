#include "core/graph/components.h"

#include <gtest/gtest.h>

#include "tests/support/random_graph.h"

namespace geolloyd {
namespace {

TEST(Components, AreNumberedByTheirSmallestNode) {
  const Graph graph =
      make_graph(std::vector<UndirectedArc>{{0, 3, 1}, {1, 4, 1}}, std::vector<double>(5, 1.0));
  const Components components = connected_components(graph);
  ASSERT_EQ(components.size(), 3U);
  EXPECT_EQ(components.component_of, (std::vector<std::uint32_t>{0, 1, 2, 0, 1}));
  EXPECT_EQ(components.node, (std::vector<NodeId>{0, 3, 1, 4, 2}));
}

TEST(Components, AreClosedUnderArcsAndConnected) {
  for (std::uint64_t random_seed = 0; random_seed < 50; ++random_seed) {
    const Graph graph = random_graph(random_seed, 30);
    const Components components = connected_components(graph);
    std::size_t nodes = 0;
    for (std::size_t c = 0; c < components.size(); ++c) {
      nodes += components.nodes(c).size();
      for (const NodeId v : components.nodes(c)) {
        EXPECT_EQ(components.component_of[v], c);
        for (const NodeId u : graph.neighbours(v)) EXPECT_EQ(components.component_of[u], c);
      }
    }
    EXPECT_EQ(nodes, graph.node_count());
  }
}

}  // namespace
}  // namespace geolloyd
