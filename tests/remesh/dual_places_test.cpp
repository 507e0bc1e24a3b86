// Where the vertices of a remesh stand: on a boundary, but never three of a triangle in one line.
#include "core/remesh/dual_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/shapes/shapes.h"
#include "tests/remesh/ground.h"
#include "tests/support/graph_kinds.h"
#include "tests/support/random_graph.h"

namespace geolloyd {
namespace {

// Height over the longest edge, divided by that edge.
double flatness(const Mesh& mesh, const Triangle& t) {
  const auto& [a, b, c] = t;
  const auto& p = mesh.positions;
  const double longest = std::max({norm(p[a] - p[b]), norm(p[b] - p[c]), norm(p[c] - p[a])});
  return longest > 0 ? norm(cross(p[b] - p[a], p[c] - p[a])) / (longest * longest) : 0;
}

std::size_t count_repeated_places(const Mesh& mesh) {
  std::vector<std::array<double, 3>> places;
  for (const Vec3& p : mesh.positions) places.push_back({p.x(), p.y(), p.z()});
  std::sort(places.begin(), places.end());
  const auto end = std::unique(places.begin(), places.end());
  return static_cast<std::size_t>(places.end() - end);
}

// A right triangle of rows of triangles, in any position.
Mesh big_triangle(VertexId rows) {
  Mesh mesh;
  const auto vertex = [](VertexId i, VertexId j) { return i * (i + 1) / 2 + j; };
  for (VertexId i = 0; i <= rows; ++i) {
    for (VertexId j = 0; j <= i; ++j) {
      mesh.positions.emplace_back(0.3 * i + 0.1 * j, 0.2 * i - 0.3 * j, 0.1 * i + 0.1 * j);
    }
  }
  for (VertexId i = 0; i < rows; ++i) {
    for (VertexId j = 0; j <= i; ++j) {
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      if (j < i) mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return mesh;
}

class DualPlaces : public testing::TestWithParam<GraphKind> {};

TEST_P(DualPlaces, MakeNoTriangleFlatAndRepeatNoPlace) {
  for (const Mesh& mesh :
       {irregular_plane(300, 1), irregular_plane(2000, 2), big_triangle(12), big_triangle(30)}) {
    Ground ground(mesh, GetParam());
    for (std::uint64_t random_seed = 0; random_seed < 20; ++random_seed) {
      const std::size_t count = 3 + random_number(random_seed, 0, 40);
      const Mesh remesh = ground.remesh(ground.repair(ground.choose(count, random_seed)));
      EXPECT_EQ(count_repeated_places(remesh), 0U) << count;
      for (const Triangle& t : remesh.triangles) {
        EXPECT_GT(flatness(remesh, t), 1e-6) << mesh.triangle_count() << " " << random_seed;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllGraphs, DualPlaces, testing::ValuesIn(all_kinds));

// A seam: two squares beside each other whose boundaries coincide, each with vertices of its own.
TEST(DualPlacesAtASeam, AreNotRepeated) {
  for (const GraphKind kind : all_kinds) {
    Mesh seam = irregular_plane(500, 1);
    const Mesh other = irregular_plane(500, 1);
    const auto shift = static_cast<VertexId>(seam.vertex_count());
    for (const Vec3& p : other.positions) seam.positions.emplace_back(-p.x(), p.y(), 0);
    for (const auto& [a, b, c] : other.triangles) {
      seam.triangles.push_back({a + shift, c + shift, b + shift});
    }
    Ground ground(seam, kind);
    const Mesh remesh = ground.remesh(ground.repair(ground.choose(40)));
    EXPECT_EQ(count_repeated_places(remesh), 0U);
  }
}

}  // namespace
}  // namespace geolloyd
