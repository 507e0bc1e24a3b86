// The graph of triangles that are joined across edges and by way of vertices, beside all its ways
// one by one.
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/graph/arc_length.h"
#include "core/graph/mesh_graph.h"
#include "core/shapes/shapes.h"

namespace geolloyd {
namespace {

// Triangles at random: most edges have one of them or several, turned either way, and some
// triangles are there twice or name a vertex twice.
Mesh random_soup(std::uint64_t random_seed, std::uint32_t vertices, std::size_t triangles) {
  std::uint64_t n = 0;
  const auto draw = [&](std::uint32_t bound) {
    return static_cast<std::uint32_t>(random_below(random_seed, n++, bound));
  };
  Mesh mesh;
  for (std::uint32_t v = 0; v < vertices; ++v) {
    mesh.positions.emplace_back(draw(9), draw(9), draw(9));
  }
  for (std::size_t t = 0; t < triangles; ++t) {
    mesh.triangles.push_back({draw(vertices), draw(vertices), draw(vertices)});
  }
  mesh.triangles.push_back({0, 1, 2});
  return mesh;
}

std::vector<UndirectedArc> all_ways(const Mesh& mesh, const MeshEdges& edges,
                                    const MeshGraph& made) {
  const auto node = [&](CornerId corner) { return made.node_of[triangle_of(corner)]; };
  const auto leg = [&](CornerId corner) {
    return norm(mesh.positions[apex(mesh, corner)] - made.position[node(corner)]);
  };
  std::vector<UndirectedArc> ways;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto corners = edges.corners(e);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = i + 1; j < corners.size(); ++j) {
        ways.push_back({node(corners[i]), node(corners[j]),
                        unfolded_distance(
                            made.position[node(corners[i])], made.position[node(corners[j])],
                            mesh.positions[edges.ends[e][0]], mesh.positions[edges.ends[e][1]])});
      }
    }
  }
  std::vector<std::vector<CornerId>> fans(mesh.vertex_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for_each_corner(mesh, t, [&](CornerId corner) {
      for (const CornerId other : fans[apex(mesh, corner)]) {
        ways.push_back({node(other), node(corner), leg(other) + leg(corner)});
      }
      fans[apex(mesh, corner)].push_back(corner);
    });
  }
  return ways;
}

void expect_all_ways(const Mesh& mesh) {
  const MeshEdges edges = find_edges(mesh);
  const MeshGraph made =
      make_mesh_graph(mesh, edges, {GraphKind::triangle_dense, Norm::geodesic, {}});
  const std::vector<UndirectedArc> ways = all_ways(mesh, edges, made);
  EXPECT_LE(ways.size(), count_arcs(mesh, edges, GraphKind::triangle_dense));
  const Graph expected = make_graph(ways, std::vector<double>(made.graph.node_count(), 1.0));
  ASSERT_EQ(made.graph.first_arc, expected.first_arc);
  ASSERT_EQ(made.graph.target, expected.target);
  ASSERT_EQ(made.graph.length, expected.length);
  ASSERT_EQ(made.graph.tick_length, expected.tick_length);
}

TEST(DenseGraph, HasTheShortestOfAllWaysOfAMesh) {
  expect_all_ways(creature(3000, 1));
}

TEST(DenseGraph, HasTheShortestOfAllWaysWhateverTheTriangles) {
  for (std::uint32_t random_seed = 0; random_seed < 300; ++random_seed) {
    expect_all_ways(random_soup(random_seed, 4 + random_seed % 9, 1 + random_seed % 30));
  }
}

}  // namespace
}  // namespace geolloyd
