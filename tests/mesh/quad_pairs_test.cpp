#include "core/mesh/quad_pairs.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

#include "core/base/vec3.h"
#include "core/mesh/mesh_measure.h"
#include "core/mesh/subdivide.h"
#include "core/shapes/shapes.h"

namespace geolloyd {
namespace {

QuadPairs pairs_of(const Mesh& mesh) {
  return pair_triangles(mesh, find_edges(mesh));
}

Mesh cut_square() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

// Each triangle is in one face, and a face of two has the corners of both.
void expect_all_triangles(const Mesh& mesh, const QuadPairs& found) {
  std::size_t quads = 0;
  for (const Face& face : found.faces) quads += face.is_quad() ? 1 : 0;
  EXPECT_EQ(quads, found.quads);
  EXPECT_EQ(found.faces.size() + quads, mesh.triangle_count());
}

// Twice the area, along the normal of the diagonals.
double area_of(const Mesh& mesh, const Face& face) {
  const auto& [a, b, c, d] = face.corners;
  const std::vector<Vec3>& p = mesh.positions;
  return face.is_quad() ? norm(cross(p[c] - p[a], p[d] - p[b])) / 2
                        : norm(cross(p[b] - p[a], p[c] - p[a])) / 2;
}

TEST(QuadPairs, MakeASquareOfTwoTriangles) {
  const QuadPairs found = pairs_of(cut_square());
  ASSERT_EQ(found.faces.size(), 1U);
  EXPECT_EQ(found.faces[0].corners, (std::array<VertexId, 4>{1, 2, 3, 0}));
  EXPECT_NEAR(found.smallest_angle, 90, 1e-9);
  EXPECT_NEAR(found.largest_angle, 90, 1e-9);
}

TEST(QuadPairs, MakeAllSquaresOfAGrid) {
  const Mesh mesh = refine(cut_square(), 20);
  const QuadPairs found = pairs_of(mesh);
  expect_all_triangles(mesh, found);
  EXPECT_EQ(found.quads, 400U);
  EXPECT_NEAR(found.smallest_angle, 90, 1e-6);
}

TEST(QuadPairs, CoverAPlaneWithConvexFaces) {
  const Mesh mesh = irregular_plane(2'000, 1);
  const QuadPairs found = pairs_of(mesh);
  expect_all_triangles(mesh, found);
  EXPECT_GT(20 * found.quads, 9 * found.faces.size());
  EXPECT_GE(found.smallest_angle, 30 - 1e-9);
  EXPECT_LE(found.largest_angle, 150 + 1e-9);
  double area = 0;
  for (const Face& face : found.faces) area += area_of(mesh, face);
  EXPECT_NEAR(area, 1, 1e-12);
}

TEST(QuadPairs, LeaveThreeEdgesAtEachVertexOfAClosedSurface) {
  for (const Mesh& mesh : {icosphere(320), torus(600, 1), cube(600)}) {
    const QuadPairs found = pairs_of(mesh);
    expect_all_triangles(mesh, found);
    std::vector<std::size_t> faces(mesh.vertex_count(), 0);
    for (const Face& face : found.faces) {
      for (const VertexId v : face.corners) {
        if (v != no_id) ++faces[v];
      }
    }
    for (const std::size_t count : faces) EXPECT_GE(count, 3U);
  }
}

//  3   an arrow: over 0-2 the corner at 2 would be over 180 degrees
TEST(QuadPairs, AreConvex) {
  const Mesh arrow{{{0, 0, 0}, {4, -1, 0}, {1, 0, 0}, {4, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  EXPECT_EQ(pairs_of(arrow).quads, 0U);
}

TEST(QuadPairs, DoNotFold) {
  Mesh folded = cut_square();
  folded.positions[3] = {0.9, 0.1, 0.5};
  EXPECT_EQ(pairs_of(folded).quads, 0U);
}

// Opposite orientations, three triangles at an edge, a triangle twice, one without area.
TEST(QuadPairs, TakeAnyMesh) {
  Mesh turned = cut_square();
  std::swap(turned.triangles[1][0], turned.triangles[1][1]);
  EXPECT_EQ(pairs_of(turned).quads, 0U);
  Mesh book = cut_square();
  book.positions.emplace_back(0, 0, 1);
  book.triangles.push_back({0, 2, 4});
  EXPECT_EQ(pairs_of(book).quads, 0U);
  const Mesh flat{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}},
                  {{0, 1, 2}, {0, 0, 1}, {1, 0, 3}, {0, 1, 2}}};
  EXPECT_EQ(pairs_of(flat).faces.size(), 4U);
  EXPECT_TRUE(pairs_of({}).faces.empty());
}

// Of a strip of four triangles the best pair is in the middle; the ends are not left alone.
TEST(QuadPairs, PairTheTrianglesBesideAPair) {
  const Mesh strip{{{0, 0, 0}, {1.3, 0, 0}, {0.6, 1, 0}, {1.9, 1, 0}, {2.6, 0.1, 0}, {3, 1, 0}},
                   {{0, 1, 2}, {1, 3, 2}, {1, 4, 3}, {4, 5, 3}}};
  EXPECT_EQ(pairs_of(strip).quads, 2U);
}

}  // namespace
}  // namespace geolloyd
