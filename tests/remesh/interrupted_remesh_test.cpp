#include <gtest/gtest.h>

#include <vector>

#include "core/lloyd/reference_engine.h"
#include "core/mesh/mesh_edges.h"
#include "core/remesh/remesh.h"
#include "core/shapes/shapes.h"

namespace geolloyd {
namespace {

// The remesh of three regions of a torus, which needs many seeds more.
GraphRemesh remesh_torus(const std::function<bool()>& keep_going) {
  const Mesh mesh = torus(2000, 1);
  const MeshGraph mesh_graph =
      make_mesh_graph(mesh, find_edges(mesh), {GraphKind::vertex, Norm::geodesic, {}});
  const std::vector<NodeId> seeds = {0, 300, 600};
  const auto engine = make_reference_engine(mesh_graph.graph);
  GraphRemeshOptions options;
  options.keep_going = keep_going;
  const Partition partition = partition_of(*engine, seeds);
  return make_remesh({mesh, mesh_graph, seeds, partition, *engine}, options);
}

TEST(InterruptedRemesh, SaysThatItIs) {
  const GraphRemesh remesh = remesh_torus([] { return false; });
  EXPECT_TRUE(remesh.interrupted);
  EXPECT_EQ(remesh.seeds_added, 0U);
  EXPECT_EQ(remesh.why_left, ViolationsLeft::stopped);
}

TEST(InterruptedRemesh, HasTheSeedsAddedSoFar) {
  int calls = 0;
  const GraphRemesh remesh = remesh_torus([&] { return ++calls < 2; });
  EXPECT_TRUE(remesh.interrupted);
  EXPECT_GT(remesh.seeds_added, 0U);
  EXPECT_EQ(calls, 2);
}

TEST(InterruptedRemesh, IsNoOtherRemesh) {
  const GraphRemesh remesh = remesh_torus([] { return true; });
  EXPECT_FALSE(remesh.interrupted);
  EXPECT_EQ(remesh.why_left, ViolationsLeft::none);
}

}  // namespace
}  // namespace geolloyd
