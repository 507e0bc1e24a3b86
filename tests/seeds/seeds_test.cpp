#include "core/seeds/seeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/graph/mesh_graph.h"
#include "core/shapes/shapes.h"
#include "geolloyd/errors.h"
#include "tests/support/naive.h"
#include "tests/support/random_graph.h"

namespace geolloyd {
namespace {

constexpr std::array all_inits = {SeedInit::random, SeedInit::random_area, SeedInit::farthest,
                                  SeedInit::kmeans_plus_plus};

std::vector<NodeId> choose(const Graph& graph, SeedInit init, std::size_t count,
                           std::uint64_t random_seed = 1) {
  return choose_seeds(graph, connected_components(graph), init, count, random_seed);
}

TEST(Seeds, AreDifferentNodesAndReachEveryComponentWhateverTheirNumber) {
  for (std::uint64_t random_seed = 0; random_seed < 40; ++random_seed) {
    const Graph graph = random_graph(random_seed, 25);
    const Components components = connected_components(graph);
    for (const SeedInit init : all_inits) {
      for (std::size_t count = components.size(); count <= 25; ++count) {
        const auto seeds = choose_seeds(graph, components, init, count, random_seed);
        ASSERT_EQ(std::set(seeds.begin(), seeds.end()).size(), count);
        std::set<std::uint32_t> reached;
        for (const NodeId s : seeds) reached.insert(components.component_of[s]);
        ASSERT_EQ(reached.size(), components.size());
      }
    }
  }
}

TEST(Seeds, ThatAreSpreadAreDifferentReachEveryComponentAndShareTheMass) {
  for (std::uint64_t random_seed = 0; random_seed < 40; ++random_seed) {
    const Graph graph = random_graph(random_seed, 25);
    const Components components = connected_components(graph);
    for (std::size_t count = components.size(); count <= 25; ++count) {
      const auto seeds = spread_nodes(graph, components, count);
      ASSERT_EQ(std::set(seeds.begin(), seeds.end()).size(), count);
      ASSERT_TRUE(std::is_sorted(seeds.begin(), seeds.end()));
      std::set<std::uint32_t> reached;
      for (const NodeId s : seeds) reached.insert(components.component_of[s]);
      ASSERT_EQ(reached.size(), components.size());
    }
  }
  const Graph row = grid_graph(90, 1);
  EXPECT_EQ(spread_nodes(row, connected_components(row), 3), (std::vector<NodeId>{14, 44, 74}));
}

TEST(Seeds, AreTheSameForTheSameRandomSeedOnly) {
  const Graph graph = grid_graph(20, 20);
  for (const SeedInit init : all_inits) {
    EXPECT_EQ(choose(graph, init, 10, 1), choose(graph, init, 10, 1));
    EXPECT_NE(choose(graph, init, 10, 1), choose(graph, init, 10, 2));
  }
}

TEST(Seeds, OfTooSmallOrTooLargeNumberAreRefusedWithAdvice) {
  const Graph graph =
      make_graph(std::vector<UndirectedArc>{{0, 1, 1}}, std::vector<double>(4, 1.0));
  const auto message = [&](std::size_t count) {
    try {
      choose(graph, SeedInit::random, count);
    } catch (const InvalidInput& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message(2).find("3 connected components"), std::string::npos);
  EXPECT_NE(message(2).find("at least 3 seeds"), std::string::npos);
  EXPECT_NE(message(5).find("more seeds (5) than graph nodes (4)"), std::string::npos);
  EXPECT_EQ(message(3), "");
}

TEST(Seeds, AreSharedOutToComponentsByMass) {
  // Two rows of 100 nodes, the second three times as heavy.
  std::vector<UndirectedArc> links;
  std::vector<double> masses;
  for (NodeId v = 0; v < 200; ++v) {
    if (v % 100 != 99) links.push_back({v, v + 1, 1});
    masses.push_back(v < 100 ? 1 : 3);
  }
  const Graph graph = make_graph(links, masses);
  for (const SeedInit init : all_inits) {
    const auto seeds = choose(graph, init, 40);
    EXPECT_EQ(std::count_if(seeds.begin(), seeds.end(), [](NodeId s) { return s < 100; }), 10);
  }
}

TEST(Seeds, FarthestPointsAreEachTheFarthestFromThoseBefore) {
  for (std::uint64_t random_seed = 0; random_seed < 30; ++random_seed) {
    const Graph graph = random_connected_graph(random_seed, 30);
    const auto seeds = choose(graph, SeedInit::farthest, 12, random_seed);
    for (std::size_t count = 1; count < seeds.size(); ++count) {
      const Partition before = naive::partition(
          graph, {seeds.begin(), seeds.begin() + static_cast<std::ptrdiff_t>(count)});
      std::uint32_t largest = 0;
      NodeId farthest = 0;
      for (NodeId v = 0; v < 30; ++v) {
        if (distance_of(before.key[v]) <= largest) continue;
        largest = distance_of(before.key[v]);
        farthest = v;
      }
      ASSERT_EQ(seeds[count], farthest);
    }
  }
}

TEST(Seeds, RandomOnesAreUniformOverNodesAndRandomAreaOnesByMass) {
  // 10 nodes, of which node 9 has half of the mass.
  std::vector<double> masses(10, 1);
  masses[9] = 9;
  std::vector<UndirectedArc> links;
  for (NodeId v = 1; v < 10; ++v) links.push_back({v - 1, v, 1});
  const Graph graph = make_graph(links, masses);
  int uniform = 0;
  int by_area = 0;
  for (std::uint64_t random_seed = 0; random_seed < 4000; ++random_seed) {
    if (choose(graph, SeedInit::random, 1, random_seed)[0] == 9) ++uniform;
    if (choose(graph, SeedInit::random_area, 1, random_seed)[0] == 9) ++by_area;
  }
  EXPECT_NEAR(uniform, 400, 80);
  EXPECT_NEAR(by_area, 2000, 150);
}

TEST(Seeds, PlusPlusPrefersWhatIsFarFromTheFirst) {
  // A row of 11 with unit arcs. Squared distances give the far end of a first seed at one end
  // 100 / 385; uniform sampling would give 1 / 10.
  const Graph graph = grid_graph(1, 11);
  int first_at_end = 0;
  int second_at_other = 0;
  for (std::uint64_t random_seed = 0; random_seed < 20000; ++random_seed) {
    const auto seeds = choose(graph, SeedInit::kmeans_plus_plus, 2, random_seed);
    if (seeds[0] != 0) continue;
    ++first_at_end;
    if (seeds[1] == 10) ++second_at_other;
  }
  EXPECT_NEAR(first_at_end, 20000 / 11, 200);
  EXPECT_NEAR(second_at_other, first_at_end * 100.0 / 385, 70);
}

TEST(Seeds, SpreadBetterTheMoreTheInitLooksAtDistances) {
  const Mesh mesh = icosphere(8000);
  const MeshGraph made = make_mesh_graph(mesh, find_edges(mesh), {});
  const auto worst = [&](SeedInit init) {
    const Partition p = naive::partition(made.graph, choose(made.graph, init, 60));
    std::uint32_t largest = 0;
    for (const Key key : p.key) largest = std::max(largest, distance_of(key));
    return largest;
  };
  EXPECT_LT(worst(SeedInit::farthest), worst(SeedInit::kmeans_plus_plus));
  EXPECT_LT(worst(SeedInit::farthest) * 1.3, worst(SeedInit::random));
}

}  // namespace
}  // namespace geolloyd
