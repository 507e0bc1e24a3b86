// First seeds that need more than the graph: near sites of the surface, and from a coarser graph.
#include "core/start/first_seeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/lloyd/relaxation.h"
#include "core/mesh/mesh_edges.h"
#include "core/shapes/shapes.h"
#include "geolloyd/errors.h"
#include "geolloyd/threads.h"
#include "tests/support/graph_kinds.h"
#include "tests/support/odd_surfaces.h"

namespace geolloyd {
namespace {

constexpr std::array new_ways = {SeedInit::surface, SeedInit::coarse, SeedInit::automatic};

struct Chosen {
  MeshGraph made;
  std::vector<NodeId> seeds;
};

Chosen choose(const Mesh& mesh, GraphKind kind, SeedInit init, std::size_t count, Runtime& runtime,
              const std::vector<TangentSpace>& field = {}) {
  const MeshEdges edges = find_edges(mesh);
  Chosen chosen{make_mesh_graph(mesh, edges, {kind, {}, field}), {}};
  EXPECT_EQ(count_nodes(mesh, kind), chosen.made.graph.node_count());
  const FirstSeedOptions options{init, count, 1, field};
  chosen.seeds = choose_first_seeds(
      mesh, find_first_places(mesh, edges.duplicates, count_nodes(mesh, kind), options, runtime),
      chosen.made, connected_components(chosen.made.graph), options, runtime);
  return chosen;
}

void expect_usable(const Chosen& chosen, std::size_t count) {
  EXPECT_EQ(chosen.seeds.size(), count);
  const std::set<NodeId> different(chosen.seeds.begin(), chosen.seeds.end());
  EXPECT_EQ(different.size(), count);
  EXPECT_LT(*different.rbegin(), chosen.made.graph.node_count());
  const Components components = connected_components(chosen.made.graph);
  std::set<std::uint32_t> with_seed;
  for (const NodeId s : chosen.seeds) with_seed.insert(components.component_of[s]);
  EXPECT_EQ(with_seed.size(), components.size());
}

double energy_from(const Chosen& chosen, Runtime& runtime) {
  const Graph& graph = chosen.made.graph;
  RelaxationOptions options;
  options.greedy = GreedyMode::off;
  return relax(graph, *runtime.make_engine(graph), chosen.seeds, options).energy;
}

TEST(FirstSeeds, AreAsManyAsAskedForOnGraphsOfEachKind) {
  Threads threads(2);
  const Mesh mesh = torus(1000, 1);
  for (const GraphKind kind : all_kinds) {
    for (const SeedInit init : new_ways) {
      for (const std::size_t count : {1U, 2U, 4U, 30U, 450U}) {
        SCOPED_TRACE(testing::Message() << int(kind) << " " << int(init) << " " << count);
        expect_usable(choose(mesh, kind, init, count, threads), count);
      }
    }
  }
}

TEST(FirstSeeds, AreTheSameWithAnyRuntime) {
  const Mesh mesh = creature(18000, 1);
  for (const SeedInit init : new_ways) {
    const auto expected = choose(mesh, GraphKind::vertex, init, 60, reference_runtime()).seeds;
    for (const std::size_t count : {1U, 3U}) {
      Threads threads(count);
      EXPECT_EQ(choose(mesh, GraphKind::vertex, init, 60, threads).seeds, expected);
    }
  }
}

// Each closed part would have four sites, whatever is asked for.
TEST(FirstSeeds, AreFarthestPointsWherePartsHaveHardlyMoreThanOneEach) {
  Mesh mesh;
  for (int i = 0; i < 20; ++i) append(mesh, moved(icosphere(80), {3.0 * i, 0, 0}));
  const auto seeds = [&](SeedInit init, std::size_t count) {
    return choose(mesh, GraphKind::vertex, init, count, reference_runtime()).seeds;
  };
  EXPECT_EQ(seeds(SeedInit::surface, 39), seeds(SeedInit::farthest, 39));
  EXPECT_NE(seeds(SeedInit::surface, 40), seeds(SeedInit::farthest, 40));
}

TEST(FirstSeeds, LeadToLowerEnergiesThanFarthestPoints) {
  Threads threads(2);
  const Mesh mesh = creature(30000, 1);
  const auto ratio = [&](SeedInit init, std::initializer_list<std::size_t> counts) {
    double sum = 0;
    double of_farthest = 0;
    for (const std::size_t count : counts) {
      const auto energy = [&](SeedInit way) {
        return energy_from(choose(mesh, GraphKind::vertex, way, count, threads), threads) *
               static_cast<double>(count);
      };
      sum += energy(init);
      of_farthest += energy(SeedInit::farthest);
    }
    return sum / of_farthest;
  };
  EXPECT_LT(ratio(SeedInit::coarse, {20, 50, 100}), 1);
  EXPECT_LT(ratio(SeedInit::surface, {200, 400, 800}), 1);
  EXPECT_LT(ratio(SeedInit::automatic, {20, 100, 400, 800}), 0.99);
}

// Around the axis of a torus lengths count more than across.
std::vector<TangentSpace> ring_field(const Mesh& mesh, double around, double across) {
  std::vector<TangentSpace> field;
  for (const Vec3& p : mesh.positions) {
    const Vec3 outward = normalized(Vec3(p.x(), p.y(), 0));
    const Vec3 ring = cross(Vec3::UnitZ(), outward);
    field.push_back({ring, cross(normalized(p - outward), ring), around, across});
  }
  return field;
}

TEST(FirstSeeds, FollowAField) {
  Threads threads(2);
  const Mesh mesh = torus(20'000, 1);
  for (const std::vector<TangentSpace>& field :
       {ring_field(mesh, 3, 1), ring_field(mesh, 1, 4), ring_field(mesh, 30, 10)}) {
    const auto energy = [&](SeedInit init) {
      return energy_from(choose(mesh, GraphKind::vertex, init, 300, threads, field), threads);
    };
    EXPECT_LT(energy(SeedInit::surface), energy(SeedInit::farthest));
  }
}

TEST(FirstSeeds, AreFarthestPointsWhereSitesCannotFollowAField) {
  Threads threads(2);
  const Mesh mesh = torus(2000, 1);
  for (const std::vector<TangentSpace>& field :
       {ring_field(mesh, 0, 1), ring_field(mesh, 1000, 1)}) {
    EXPECT_EQ(choose(mesh, GraphKind::vertex, SeedInit::surface, 40, threads, field).seeds,
              choose(mesh, GraphKind::vertex, SeedInit::farthest, 40, threads, field).seeds);
  }
}

TEST(FirstSeeds, AreChosenInTheWayThatSuitsTheNumbers) {
  EXPECT_EQ(suited_init(700'000, 1), SeedInit::coarse);
  EXPECT_EQ(suited_init(700'000, 128), SeedInit::coarse);
  EXPECT_EQ(suited_init(700'000, 129), SeedInit::surface);
  EXPECT_EQ(suited_init(10'000, 100), SeedInit::surface);
  EXPECT_EQ(suited_init(10'000, 4'000), SeedInit::farthest);
  EXPECT_EQ(suited_init(1, 1), SeedInit::farthest);
  Threads threads(2);
  const Mesh mesh = creature(2000, 1);
  for (const std::size_t count : {3U, 100U, 500U}) {
    const auto chosen = choose(mesh, GraphKind::vertex, SeedInit::automatic, count, threads);
    const SeedInit suited = suited_init(chosen.made.graph.node_count(), count);
    EXPECT_EQ(chosen.seeds, choose(mesh, GraphKind::vertex, suited, count, threads).seeds);
  }
}

// Three parts, one of them a triangle, and an area of 0 in another.
Mesh in_parts() {
  Mesh mesh = icosphere(2000);
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto first = static_cast<VertexId>(mesh.positions.size());
    for (const Vec3& p : {a, b, c}) mesh.positions.push_back(p);
    mesh.triangles.push_back({first, first + 1, first + 2});
  };
  add({5, 0, 0}, {6, 0, 0}, {5, 1, 0});
  add({9, 0, 0}, {9, 0, 0}, {9, 1, 0});
  return mesh;
}

TEST(FirstSeeds, AreInEachPartAndFillAllNodes) {
  Threads threads(2);
  for (const SeedInit init : new_ways) {
    const std::size_t nodes =
        choose(in_parts(), GraphKind::vertex, init, 3, threads).made.graph.node_count();
    for (const std::size_t count : {std::size_t{3}, std::size_t{40}, nodes - 1, nodes}) {
      SCOPED_TRACE(testing::Message() << int(init) << " " << count);
      expect_usable(choose(in_parts(), GraphKind::vertex, init, count, threads), count);
    }
    EXPECT_THROW(choose(in_parts(), GraphKind::vertex, init, 2, threads), InvalidInput);
    EXPECT_THROW(choose(in_parts(), GraphKind::vertex, init, nodes + 1, threads), InvalidInput);
  }
}

TEST(FirstSeeds, OfAMeshWithoutAreaAreFarthestPoints) {
  Mesh mesh = irregular_plane(100, 1);
  for (Vec3& p : mesh.positions) p = {p.x(), 0, 0};
  for (const SeedInit init : new_ways) {
    expect_usable(choose(mesh, GraphKind::vertex, init, 10, reference_runtime()), 10);
  }
}

}  // namespace
}  // namespace geolloyd
