#include "core/mesh/connectivity.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/shapes/shapes.h"

namespace geolloyd {
namespace {

// With a triangle that names a vertex twice, and a vertex of no triangle.
Mesh odd_mesh() {
  Mesh mesh = icosphere(80);
  mesh.positions.emplace_back(2, 0, 0);
  mesh.triangles.push_back({0, 0, 1});
  return mesh;
}

TEST(Connectivity, ListsTrianglesCornersAndEdgesOfEachVertex) {
  const Mesh mesh = odd_mesh();
  const MeshEdges edges = find_edges(mesh);
  const auto triangles_at = triangles_at_vertices(mesh.vertex_count(), mesh.triangles);
  const auto corners_at = corners_at_vertices(mesh);
  const auto edges_at = edges_at_vertices(mesh.vertex_count(), edges);
  ASSERT_EQ(triangles_at.size(), mesh.vertex_count());
  ASSERT_EQ(corners_at.size(), mesh.vertex_count());
  ASSERT_EQ(edges_at.size(), mesh.vertex_count());
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    std::vector<TriangleId> triangles;
    std::vector<CornerId> corners;
    for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
      for (std::uint32_t c = 0; c < 3; ++c) {
        if (mesh.triangles[t][c] != v) continue;
        triangles.push_back(t);
        if (has_three_vertices(mesh.triangles[t])) corners.push_back(3 * t + c);
      }
    }
    std::vector<std::uint32_t> ends;
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      if (edges.ends[e][0] == v || edges.ends[e][1] == v) ends.push_back(e);
    }
    EXPECT_TRUE(std::ranges::equal(triangles_at[v], triangles)) << v;
    EXPECT_TRUE(std::ranges::equal(corners_at[v], corners)) << v;
    EXPECT_TRUE(std::ranges::equal(edges_at[v], ends)) << v;
  }
}

}  // namespace
}  // namespace geolloyd
