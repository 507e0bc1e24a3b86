#include "parallel/engine/parallel_growing_search.h"

#include <gtest/gtest.h>

#include <set>

#include "core/graph/mesh_graph.h"
#include "core/seeds/seeds.h"
#include "core/shapes/shapes.h"
#include "parallel/threads/scheduler.h"
#include "tests/support/random_graph.h"

namespace geolloyd {
namespace {

TEST(GrowingSearch, InParallelHasTheSameKeysAfterEverySeed) {
  for (std::uint64_t random_seed = 0; random_seed < 30; ++random_seed) {
    const Graph graph = random_graph(random_seed, 200);
    Scheduler scheduler(1 + random_seed % 3);
    const auto expected = make_growing_search(graph);
    const auto tested = make_parallel_growing_search(scheduler, graph);
    for (const NodeId seed : random_nodes(random_seed, 200, 40)) {
      const auto nearer = expected->add(seed);
      const auto listed = tested->add(seed);
      ASSERT_EQ(expected->keys(), tested->keys());
      ASSERT_EQ(std::set(nearer.begin(), nearer.end()), std::set(listed.begin(), listed.end()));
    }
  }
}

// Large enough that all threads take part in the first searches.
TEST(GrowingSearch, InParallelChoosesTheSameSeeds) {
  const Mesh mesh = creature(60000, 1);
  const MeshGraph made = make_mesh_graph(mesh, find_edges(mesh), {});
  const Components components = connected_components(made.graph);
  for (const SeedInit init : {SeedInit::farthest, SeedInit::kmeans_plus_plus}) {
    const auto expected = choose_seeds(made.graph, components, init, 300, 5);
    for (const std::size_t threads : {1U, 2U, 8U}) {
      Scheduler scheduler(threads);
      Threads runtime(scheduler);
      ASSERT_EQ(choose_seeds(made.graph, components, init, 300, 5, runtime), expected);
    }
  }
}

}  // namespace
}  // namespace geolloyd
