// Where the vertices of a remesh stand: on a boundary, but never three of a triangle in one line.
#include "core/regions/dual_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/shapes/shapes.h"
#include "tests/regions/ground.h"
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

Mesh cone(VertexId triangles) {
  Mesh mesh;
  mesh.positions.emplace_back(0, 0, 0.1);
  for (VertexId i = 0; i < triangles; ++i) {
    const double turn = 2 * M_PI * i / triangles;
    mesh.positions.emplace_back(std::cos(turn), std::sin(turn), 0);
    mesh.triangles.push_back({0, i + 1, (i + 1) % triangles + 1});
  }
  return mesh;
}

// Where all regions meet. To try every place for each triangle around it took a minute.
TEST(DualPlacesAtAHub, AreFoundInTimeThatGrowsWithTheRegions) {
  Ground ground(cone(40'000), GraphKind::triangle);
  std::vector<NodeId> seeds;
  for (std::size_t t = 0; t < 40'000; t += 20) {
    seeds.push_back(ground.mesh_graph.node_of[ground.mesh_graph.first_triangle_id + t]);
  }
  const Mesh remesh = ground.remesh(ground.dualise(seeds));
  EXPECT_EQ(remesh.vertex_count(), seeds.size());
}

// To count all that share a place, for each of them, took minutes.
TEST(DualPlacesInOnePlace, AreFoundInTimeThatGrowsWithTheRegions) {
  Mesh mesh = irregular_plane(40'000, 1);
  std::fill(mesh.positions.begin(), mesh.positions.end(), Vec3::Zero());
  Ground ground(mesh, GraphKind::vertex);
  std::vector<NodeId> seeds;
  for (NodeId v = 0; v < ground.mesh_graph.graph.node_count(); v += 4) seeds.push_back(v);
  const Mesh remesh = ground.remesh(ground.dualise(seeds));
  EXPECT_EQ(count_repeated_places(remesh), seeds.size() - 1);
}

}  // namespace
}  // namespace geolloyd
