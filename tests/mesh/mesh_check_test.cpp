#include "core/mesh/mesh_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/mesh_measure.h"
#include "core/shapes/shapes.h"

namespace geolloyd {
namespace {

MeshFacts facts_of(const Mesh& mesh) {
  return check_mesh(mesh, find_edges(mesh));
}

const std::vector<Vec3> square_corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST(MeshEdges, ListEachEdgeOnceWithTheCornersOppositeToIt) {
  //  3---2
  //  | / |
  //  0---1
  const Mesh mesh{square_corners, {{0, 1, 2}, {0, 2, 3}}};
  const MeshEdges edges = find_edges(mesh);
  EXPECT_EQ(edges.ends,
            (std::vector<std::array<VertexId, 2>>{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}}));
  ASSERT_EQ(edges.corners(1).size(), 2U);
  EXPECT_EQ(apex(mesh, edges.corners(1)[0]), 1U);
  EXPECT_EQ(apex(mesh, edges.corners(1)[1]), 3U);
  EXPECT_EQ(edges.corners(0).size(), 1U);
}

TEST(MeshCheck, KnowsASphereATorusAndADisc) {
  const MeshFacts sphere = facts_of(icosphere(500));
  EXPECT_EQ(sphere.euler_characteristic, 2);
  EXPECT_EQ(sphere.boundary_edges, 0U);
  EXPECT_EQ(sphere.components, 1U);
  EXPECT_EQ(facts_of(torus(500, 1)).euler_characteristic, 0);
  const MeshFacts disc = facts_of(Mesh{square_corners, {{0, 1, 2}, {0, 2, 3}}});
  EXPECT_EQ(disc.euler_characteristic, 1);
  EXPECT_EQ(disc.boundary_edges, 4U);
  EXPECT_DOUBLE_EQ(disc.area, 1);
  EXPECT_DOUBLE_EQ(disc.bounding_diagonal, std::sqrt(2));
}

TEST(MeshCheck, MeasuresOnlyWhatIsOnTriangles) {
  Mesh mesh{square_corners, {{0, 1, 2}, {0, 2, 3}}};
  mesh.positions.emplace_back(1000, 0, 0);
  EXPECT_DOUBLE_EQ(facts_of(mesh).bounding_diagonal, std::sqrt(2));
}

TEST(MeshCheck, CountsWhatIsUnusual) {
  Mesh mesh{square_corners, {{0, 1, 2}, {0, 2, 3}}};
  mesh.positions.emplace_back(9, 9, 9);  // 4: of no triangle
  mesh.positions.emplace_back(0, 0, 0);  // 5: at the place of 0
  mesh.positions.emplace_back(0, 0, 1);  // 6
  mesh.triangles.push_back({1, 1, 2});   // names a vertex twice
  mesh.triangles.push_back({2, 0, 1});   // the first one again, turned
  mesh.triangles.push_back({3, 0, 5});   // no area; an edge without length
  mesh.triangles.push_back({0, 2, 6});   // a third triangle at edge 0-2
  const MeshFacts facts = facts_of(mesh);
  EXPECT_EQ(facts.vertices, 7U);
  EXPECT_EQ(facts.triangles, 6U);
  EXPECT_EQ(facts.unreferenced_vertices, 1U);
  EXPECT_EQ(facts.repeated_vertex_triangles, 1U);
  EXPECT_EQ(facts.duplicate_triangles, 1U);
  EXPECT_EQ(facts.zero_area_triangles, 1U);
  EXPECT_EQ(facts.zero_length_edges, 1U);
  EXPECT_EQ(facts.non_manifold_edges, 1U);
  EXPECT_NEAR(facts.area, 1 + 0.5 * std::sqrt(2), 1e-14);
}

TEST(MeshCheck, CountsEdgesBetweenOppositeOrientations) {
  EXPECT_EQ(facts_of(Mesh{square_corners, {{0, 1, 2}, {0, 2, 3}}}).inconsistent_edges, 0U);
  EXPECT_EQ(facts_of(Mesh{square_corners, {{0, 1, 2}, {0, 3, 2}}}).inconsistent_edges, 1U);
}

TEST(MeshCheck, CountsComponents) {
  Mesh two = icosphere(20);
  const auto shift = static_cast<VertexId>(two.vertex_count());
  const Mesh one = two;
  for (const Vec3& p : one.positions) two.positions.emplace_back(p + Vec3(5, 0, 0));
  for (const Triangle& t : one.triangles)
    two.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  EXPECT_EQ(facts_of(two).components, 2U);
  EXPECT_EQ(facts_of(two).euler_characteristic, 4);
}

TEST(MeshMeasure, FindsEveryCopyOfATriangle) {
  Mesh mesh{square_corners, {{0, 1, 2}, {0, 2, 3}, {1, 2, 0}, {2, 1, 0}, {3, 2, 0}}};
  EXPECT_EQ(find_edges(mesh).duplicates, (std::vector<TriangleId>{2, 3, 4}));
}

TEST(MeshMeasure, SharesTheAreaAmongVertices) {
  const Mesh mesh = icosphere(2000);
  const Buffer<double> of_triangle = triangle_areas(mesh, {});
  double by_triangle = 0;
  double by_vertex = 0;
  for (const double a : of_triangle) by_triangle += a;
  for (const double a : vertex_areas(mesh, {})) by_vertex += a;
  EXPECT_NEAR(by_triangle, by_vertex, 1e-12);
  EXPECT_NEAR(by_triangle, 4 * M_PI, 0.05);
}

}  // namespace
}  // namespace geolloyd
