#include "core/surface/substrate/fine_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/shapes/shapes.h"
#include "tests/support/random_graph.h"
#include "tests/support/surface.h"

namespace geolloyd {
namespace {

bool names(const Triangle& t, VertexId v) {
  return std::count(t.begin(), t.end(), v) > 0;
}

// By asking every triangle.
VertexId brute_across(const FineMesh& mesh, TriangleId t, std::size_t corner) {
  const VertexId u = mesh.triangles[t][(corner + 1) % 3];
  const VertexId v = mesh.triangles[t][(corner + 2) % 3];
  std::vector<VertexId> beyond;
  for (TriangleId other = 0; other < mesh.triangle_count(); ++other) {
    if (other == t || !names(mesh.triangles[other], u) || !names(mesh.triangles[other], v))
      continue;
    for (const VertexId w : mesh.triangles[other]) {
      if (w != u && w != v) beyond.push_back(w);
    }
  }
  return beyond.size() == 1 ? beyond[0] : no_id;
}

void expect_connected_right(const FineMesh& mesh) {
  ASSERT_EQ(mesh.first_neighbour.size(), mesh.vertex_count() + 1);
  ASSERT_EQ(mesh.first_triangle.size(), mesh.vertex_count() + 1);
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    std::vector<TriangleId> around;
    std::set<VertexId> near;
    for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
      if (!names(mesh.triangles[t], v)) continue;
      around.push_back(t);
      near.insert(mesh.triangles[t].begin(), mesh.triangles[t].end());
    }
    near.erase(v);
    EXPECT_TRUE(std::ranges::equal(mesh.triangles_at(v), around)) << v;
    EXPECT_TRUE(std::ranges::equal(mesh.neighbours(v), near)) << v;
  }
  ASSERT_EQ(mesh.across_open.size(), mesh.triangle_count());
  double area = 0;
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_EQ(mesh.across_open[t][c], brute_across(mesh, t, c)) << t;
    const auto& [a, b, c] = mesh.triangles[t];
    const std::vector<Vec3>& p = mesh.positions;
    EXPECT_EQ(mesh.area(t), norm(cross(p[b] - p[a], p[c] - p[a])) / 2);
    area += mesh.area(t);
  }
  EXPECT_EQ(mesh.whole_area, area);
}

FineMesh connected(Mesh mesh) {
  FineMesh fine;
  fine.positions = std::move(mesh.positions);
  fine.triangles = std::move(mesh.triangles);
  connect(fine);
  return fine;
}

TEST(FineMeshConnections, OfShapes) {
  expect_connected_right(connected(icosphere(180)));
  expect_connected_right(connected(torus(200, 1)));
  expect_connected_right(connected(irregular_plane(150, 1)));
  expect_connected_right(connected(cylinder(150, 1)));
}

// Edges of three and more triangles, triangles named twice, in both directions, and vertices of
// none.
TEST(FineMeshConnections, OfRandomSoups) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    Mesh soup;
    for (std::uint64_t v = 0; v < 9; ++v) soup.positions.push_back(random_point(seed, v));
    const std::uint32_t count = random_number(seed, 100, 25);
    for (std::uint64_t n = 101; soup.triangle_count() < count; n += 3) {
      const Triangle t = {random_number(seed, n, 9), random_number(seed, n + 1, 9),
                          random_number(seed, n + 2, 9)};
      if (has_three_vertices(t)) soup.triangles.push_back(t);
    }
    expect_connected_right(connected(std::move(soup)));
  }
}

TEST(FineMeshConnections, OfABoundaryEndThere) {
  const FineMesh mesh =
      connected({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}}});
  EXPECT_EQ(mesh.across_open[0], (Triangle{3, no_id, no_id}));
  EXPECT_EQ(mesh.across_open[1], (Triangle{no_id, 0, no_id}));
  EXPECT_EQ(mesh.whole_area, 1);
}

TEST(FineMeshConnections, OfNothing) {
  FineMesh mesh;
  connect(mesh);
  EXPECT_EQ(mesh.first_neighbour, std::vector<std::uint32_t>{0});
  EXPECT_EQ(mesh.whole_area, 0);
}

}  // namespace
}  // namespace geolloyd
