#include "core/seeds/farthest_points.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/graph/components.h"
#include "core/graph/mesh_graph.h"
#include "core/seeds/seeds.h"
#include "core/shapes/shapes.h"
#include "core/voronoi/growing_search.h"
#include "parallel/threads/scheduler.h"
#include "tests/support/random_graph.h"

namespace geolloyd {
namespace {

// One after the other, by a look at all nodes.
std::vector<NodeId> chosen_plainly(const Graph& graph, std::span<const NodeId> nodes,
                                   std::span<const NodeId> first, std::size_t count) {
  const auto search = make_growing_search(graph);
  for (const NodeId v : first) search->add(v);
  std::vector<NodeId> chosen;
  while (chosen.size() < count) {
    NodeId farthest = nodes.front();
    for (const NodeId v : nodes) {
      if (distance_of(search->keys()[v]) > distance_of(search->keys()[farthest])) farthest = v;
    }
    search->add(farthest);
    chosen.push_back(farthest);
  }
  return chosen;
}

// The numbers `counts` of nodes of each component, by any number of threads.
void expect_as_chosen_plainly(const Graph& graph, std::uint64_t random_seed,
                              const std::vector<std::size_t>& threads) {
  const Components components = connected_components(graph);
  for (const std::size_t count : threads) {
    Scheduler scheduler(count);
    FarthestPoints farthest(graph, scheduler);
    for (std::size_t c = 0; c < components.size(); ++c) {
      const auto nodes = components.nodes(c);
      const auto size = static_cast<NodeId>(nodes.size());
      std::vector<NodeId> first = random_nodes(random_seed, size, 1 + random_seed % size % 3);
      for (NodeId& v : first) v = nodes[v];
      for (const std::size_t asked :
           {std::size_t{1}, nodes.size() / 3, nodes.size() - first.size()}) {
        if (asked + first.size() > nodes.size()) continue;
        ASSERT_EQ(farthest.choose(nodes, first, asked), chosen_plainly(graph, nodes, first, asked));
      }
    }
  }
}

TEST(FarthestPoints, OfSmallGraphsAreThoseChosenOneByOne) {
  for (std::uint64_t random_seed = 0; random_seed < 60; ++random_seed) {
    expect_as_chosen_plainly(random_graph(random_seed, 60), random_seed, {1, 3});
    expect_as_chosen_plainly(random_connected_graph(random_seed, 300), random_seed, {1, 2});
  }
}

// All lengths are equal, so that nearly all choices are among equals.
TEST(FarthestPoints, OfGridsAreThoseChosenOneByOne) {
  for (const NodeId columns : {1U, 2U, 7U, 40U}) {
    expect_as_chosen_plainly(grid_graph(25, columns), columns, {1, 2, 5});
  }
}

// All leaves are lowered at once, so by all threads.
TEST(FarthestPoints, OfAStarAreThoseChosenOneByOne) {
  constexpr NodeId leaves = 6000;
  std::vector<UndirectedArc> links;
  for (NodeId v = 1; v <= leaves; ++v) links.push_back({0, v, 1.0 + v % 7});
  const Graph graph = make_graph(links, std::vector<double>(leaves + 1, 1.0));
  std::vector<NodeId> nodes(leaves + 1);
  std::iota(nodes.begin(), nodes.end(), NodeId{0});
  const auto expected = chosen_plainly(graph, nodes, {{0}}, 50);
  for (const std::size_t threads : {1U, 2U, 8U}) {
    Scheduler scheduler(threads);
    EXPECT_EQ(FarthestPoints(graph, scheduler).choose(nodes, {{0}}, 50), expected);
  }
}

TEST(FarthestPoints, OfMeshesAreThoseChosenOneByOne) {
  const Mesh mesh = creature(20'000, 1);
  for (const GraphKind kind : {GraphKind::vertex, GraphKind::triangle_dense}) {
    const MeshGraph made = make_mesh_graph(mesh, find_edges(mesh), {kind, Norm::geodesic, {}});
    const Components components = connected_components(made.graph);
    const std::vector<NodeId> first = {17, 4000};
    const auto expected = chosen_plainly(made.graph, components.nodes(0), first, 700);
    for (const std::size_t threads : {1U, 2U, 3U, 8U}) {
      Scheduler scheduler(threads);
      FarthestPoints farthest(made.graph, scheduler);
      for (const std::size_t count : {2U, 90U, 700U}) {
        EXPECT_EQ(
            farthest.choose(components.nodes(0), first, count),
            std::vector(expected.begin(), expected.begin() + static_cast<std::ptrdiff_t>(count)));
      }
    }
  }
}

}  // namespace
}  // namespace geolloyd
