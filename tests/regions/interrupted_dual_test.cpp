#include <gtest/gtest.h>

#include <vector>

#include "core/lloyd/reference_engine.h"
#include "core/mesh/mesh_edges.h"
#include "core/regions/graph_dual.h"
#include "core/regions/regions_of_nodes.h"
#include "core/shapes/shapes.h"

namespace geolloyd {
namespace {

// The remesh of three regions of a torus, which needs many seeds more.
GraphDual remesh_torus(const std::function<bool()>& keep_going) {
  const Mesh mesh = torus(2000, 1);
  const MeshGraph mesh_graph =
      make_mesh_graph(mesh, find_edges(mesh), {GraphKind::vertex, Norm::geodesic, {}});
  const std::vector<NodeId> seeds = {0, 300, 600};
  const auto engine = make_reference_engine(mesh_graph.graph);
  GraphDualOptions options;
  options.keep_going = keep_going;
  const Partition partition = partition_of(*engine, seeds);
  return make_graph_dual({mesh, mesh_graph, seeds, partition, *engine}, options);
}

TEST(InterruptedRemesh, SaysThatItIs) {
  const GraphDual remesh = remesh_torus([] { return false; });
  EXPECT_TRUE(remesh.interrupted);
  EXPECT_EQ(remesh.seeds_added, 0U);
  EXPECT_EQ(remesh.why_left, ViolationsLeft::stopped);
}

TEST(InterruptedRemesh, HasTheSeedsAddedSoFar) {
  int calls = 0;
  const GraphDual remesh = remesh_torus([&] { return ++calls < 2; });
  EXPECT_TRUE(remesh.interrupted);
  EXPECT_GT(remesh.seeds_added, 0U);
  EXPECT_EQ(calls, 2);
}

TEST(InterruptedRemesh, IsNoOtherRemesh) {
  const GraphDual remesh = remesh_torus([] { return true; });
  EXPECT_FALSE(remesh.interrupted);
  EXPECT_EQ(remesh.why_left, ViolationsLeft::none);
}

// Whether it finds the edges of its mesh or is told of them.
TEST(GraphDual, IsTheSameFromWhatIsKnownOfTheEdges) {
  Mesh mesh = irregular_plane(2000, 1);
  mesh.triangles.push_back({0, 1, 500});  // at edges of three triangles, perhaps
  mesh.triangles.push_back({3, 3, 4});
  const MeshEdges edges = find_edges(mesh);
  const MeshGraph mesh_graph =
      make_mesh_graph(mesh, edges, {GraphKind::vertex, Norm::geodesic, {}});
  const std::vector<NodeId> seeds = {0, 300, 600, 900};
  const auto engine = make_reference_engine(mesh_graph.graph);
  const Partition partition = partition_of(*engine, seeds);
  const InputSurface known{find_topology(mesh, edges), irregular_edges(edges)};
  const GraphDualInput input{mesh, mesh_graph, seeds, partition, *engine};
  const GraphDual found = make_graph_dual(input, {});
  const GraphDual told =
      make_graph_dual({mesh, mesh_graph, seeds, partition, *engine, sequential(), &known}, {});
  EXPECT_EQ(told.mesh.positions, found.mesh.positions);
  EXPECT_EQ(told.mesh.triangles, found.mesh.triangles);
  EXPECT_EQ(told.seeds, found.seeds);
  EXPECT_EQ(told.input_topology, found.input_topology);
  EXPECT_EQ(told.roundness.mean, found.roundness.mean);
  EXPECT_EQ(told.violations_found.size(), found.violations_found.size());
  EXPECT_LT(known.edges.size(), edges.size() / 10);
}

}  // namespace
}  // namespace geolloyd
