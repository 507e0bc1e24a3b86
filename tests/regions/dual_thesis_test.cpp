// The thesis's own meshes: from any graph, and from few seeds to many, the dual becomes the surface
// over again, by a test of its own of what a manifold is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>

#include "core/formats/mesh_io.h"
#include "core/graph/components.h"
#include "core/graph/mesh_graph.h"
#include "core/lloyd/relaxation.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_topology.h"
#include "core/regions/dual_repair.h"
#include "core/seeds/seeds.h"
#include "parallel/engine/parallel_engine.h"
#include "parallel/threads/scheduler.h"
#include "tests/support/graph_kinds.h"
#include "tests/support/sanitizers.h"

namespace geolloyd {
namespace {

// Every directed edge once, and its opposite once or, on a boundary, not at all; around every
// vertex one chain of triangles. Returns the number of vertices of which this is not true.
std::size_t count_broken_vertices(const std::vector<Triangle>& triangles) {
  std::map<std::pair<VertexId, VertexId>, VertexId> apex_of;
  std::set<VertexId> broken;
  std::map<VertexId, std::size_t> fan_size;
  for (const Triangle& t : triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      ++fan_size[t[c]];
      if (!apex_of.emplace(std::pair(t[c], t[(c + 1) % 3]), t[(c + 2) % 3]).second) {
        broken.insert({t[c], t[(c + 1) % 3]});
      }
    }
  }
  std::map<VertexId, VertexId> first;  // of a chain of triangles v, a, b: an open one's beginning
  for (const auto& [edge, apex] : apex_of) {
    const auto& [v, a] = edge;
    if (!first.contains(v) || !apex_of.contains(std::pair(a, v))) first[v] = a;
  }
  for (const auto& [v, size] : fan_size) {
    std::size_t steps = 0;
    VertexId a = first[v];
    for (auto next = apex_of.find(std::pair(v, a)); next != apex_of.end() && steps < size;
         next = apex_of.find(std::pair(v, a))) {
      a = next->second;
      ++steps;
      if (a == first[v]) break;
    }
    if (steps != size) broken.insert(v);
  }
  return broken.size();
}

class RemeshOfTheThesis : public testing::TestWithParam<const char*> {};

TEST_P(RemeshOfTheThesis, IsAManifoldOfItsTopology) {
  const std::filesystem::path folder = GEOLLOYD_SHARED_MESHES;
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the thesis's meshes are not here";
  const bool is_long = std::getenv("GEOLLOYD_LONG_TESTS") != nullptr;
  const std::string name = GetParam();
  if ((under_sanitizer || name == "hippo_hires.ply") && !is_long)
    GTEST_SKIP() << "set GEOLLOYD_LONG_TESTS to run this";
  const Mesh mesh = read(folder / name).mesh;
  Scheduler scheduler;
  const MeshEdges edges = find_edges(mesh, scheduler);
  const MeshTopology wanted = find_topology(mesh, edges);
  for (const GraphKind kind : all_kinds) {
    const MeshGraph made = make_mesh_graph(mesh, edges, {kind, Norm::geodesic, {}}, scheduler);
    const auto engine = make_parallel_engine(scheduler, made.graph);
    const std::vector<std::size_t> counts = is_long ? std::vector<std::size_t>{64, 512, 2048, 8192}
                                                    : std::vector<std::size_t>{64, 8192};
    for (const std::size_t count : counts) {
      if (count > made.graph.node_count()) continue;
      SCOPED_TRACE(testing::Message() << static_cast<int>(kind) << " " << count);
      Threads runtime(scheduler);
      RelaxationOptions options;
      options.greedy = GreedyMode::off;
      if (!is_long) options.max_macrosteps = 1;
      const std::vector<NodeId> seeds =
          relax(made.graph, *engine,
                choose_seeds(made.graph, connected_components(made.graph), SeedInit::farthest,
                             count, 1, runtime),
                options)
              .seeds;
      const DualInput input{mesh, edges, made, scheduler};
      const DualisedSeeds repaired = repair_dual(
          input, *engine, dualise(input, partition_of(*engine, seeds), seeds), [] { return true; });
      EXPECT_TRUE(repaired.dual.violations.empty());
      EXPECT_EQ(count_broken_vertices(repaired.dual.triangles), wanted.non_manifold_vertices);
      const Mesh remesh{std::vector<Vec3>(repaired.seeds.size(), Vec3::Zero()),
                        repaired.dual.triangles};
      EXPECT_EQ(find_topology(remesh, find_edges(remesh, scheduler)).parts, wanted.parts);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllMeshes, RemeshOfTheThesis,
                         testing::Values("bunny.ply", "camelhead.off", "fandisk.obj", "hippo.ply",
                                         "hippo_hires.ply", "rocker-arm.obj"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace_if(
                               name.begin(), name.end(),
                               [](char c) { return c == '.' || c == '-'; }, '_');
                           return name;
                         });

}  // namespace
}  // namespace geolloyd
