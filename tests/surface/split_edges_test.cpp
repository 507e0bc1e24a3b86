#include "core/surface/substrate/split_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "core/mesh/closest_on_triangle.h"
#include "core/mesh/mesh_measure.h"
#include "core/shapes/shapes.h"
#include "geolloyd/remesh.h"
#include "tests/support/doubled_area.h"
#include "tests/support/random_graph.h"
#include "tests/support/surface.h"
#include "tests/support/topology.h"

namespace geolloyd {
namespace {

struct SplitMesh {
  Mesh mesh;
  std::vector<TriangleId> origin;
};

SplitMesh split(const Mesh& mesh, double longest, std::size_t most = 1'000'000) {
  SplitMesh result{mesh, {}};
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) result.origin.push_back(t);
  EdgeSizes sizes;
  split_long_edges(result.mesh, result.origin, sizes, longest, most);
  return result;
}

double longest_edge_of(const Mesh& mesh) {
  double longest = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto& p = mesh.positions;
    longest = std::max({longest, norm(p[a] - p[b]), norm(p[b] - p[c]), norm(p[c] - p[a])});
  }
  return longest;
}

double distance_to(const Mesh& mesh, const Triangle& t, const Vec3& p) {
  const Vec3 a = mesh.positions[t[0]] - p;
  const Vec3 b = mesh.positions[t[1]] - p;
  const Vec3 c = mesh.positions[t[2]] - p;
  const auto [v, w] = barycentric_closest_to_origin({a, b, c});
  return norm(a + v * (b - a) + w * (c - a));
}

// The pieces of each triangle lie in it, face as it does and have its area, so they cover it, each
// point once; no edge of one is part of an edge of another.
void expect_split_right(const Mesh& mesh, const SplitMesh& split) {
  ASSERT_EQ(split.origin.size(), split.mesh.triangle_count());
  const auto kept = static_cast<std::ptrdiff_t>(mesh.vertex_count());
  ASSERT_TRUE(std::equal(mesh.positions.begin(), mesh.positions.end(), split.mesh.positions.begin(),
                         split.mesh.positions.begin() + kept));
  EXPECT_EQ(topology_of(split.mesh).parts, topology_of(mesh).parts);
  EXPECT_EQ(topology_of(split.mesh).is_manifold(), topology_of(mesh).is_manifold());
  std::vector<double> area(mesh.triangle_count(), 0);
  double farthest = 0;
  for (TriangleId t = 0; t < split.mesh.triangle_count(); ++t) {
    const Triangle& whole = mesh.triangles[split.origin[t]];
    for (const VertexId v : split.mesh.triangles[t]) {
      farthest = std::max(farthest, distance_to(mesh, whole, split.mesh.positions[v]));
    }
    const Vec3 normal = doubled_area(split.mesh, split.mesh.triangles[t]);
    EXPECT_GE(dot(normal, doubled_area(mesh, whole)), -1e-13 * norm(normal)) << t;
    area[split.origin[t]] += norm(normal) / 2;
  }
  EXPECT_LE(farthest, 1e-8);
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    const double expected = triangle_area(mesh, mesh.triangles[t]);
    EXPECT_NEAR(area[t], expected, 1e-12) << t;
  }
}

TEST(SplitEdges, LeavesNoLongOneOfShapes) {
  Mesh several = icosphere(20);
  add_mesh(several, irregular_plane(30, 1), {3, 0, 0});
  for (const Mesh& mesh :
       {icosphere(20), torus(100, 1), irregular_plane(50, 2), cylinder(40, 1), several}) {
    for (const double longest : {0.7, 0.31, 0.1}) {
      const SplitMesh result = split(mesh, longest);
      EXPECT_LE(longest_edge_of(result.mesh), longest);
      EXPECT_GT(longest_edge_of(result.mesh), longest / 4);
      expect_split_right(mesh, result);
    }
  }
}

// Triangles of any shape, with edges of one to many triangles.
TEST(SplitEdges, LeavesNoLongOneOfRandomSoups) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    Mesh mesh;
    for (std::uint64_t v = 0; v < 8; ++v) mesh.positions.push_back(random_point(seed, v));
    std::set<std::set<VertexId>> met;
    for (std::uint64_t n = 100; n < 100 + 3 * (seed % 15 + 1); n += 3) {
      const Triangle t = {random_number(seed, n, 8), random_number(seed, n + 1, 8),
                          random_number(seed, n + 2, 8)};
      const bool is_new = met.insert({t[0], t[1], t[2]}).second;
      if (is_new && has_three_vertices(t)) mesh.triangles.push_back(t);
    }
    const SplitMesh result = split(mesh, 0.15);
    EXPECT_LE(longest_edge_of(result.mesh), 0.15);
    expect_split_right(mesh, result);
  }
}

TEST(SplitEdges, ChangesNothingWhereNoneIsLong) {
  const Mesh mesh = torus(100, 1);
  for (const double longest :
       {longest_edge_of(mesh), 10.0, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    const SplitMesh result = split(mesh, longest);
    EXPECT_EQ(result.mesh.positions, mesh.positions);
    EXPECT_EQ(result.mesh.triangles, mesh.triangles);
  }
}

TEST(SplitEdges, HalvesEdges) {
  const Mesh mesh = {{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(split(mesh, 4.5).mesh.triangle_count(), 2U);  // the one of length 5
  EXPECT_EQ(split(mesh, 3.5).mesh.triangle_count(), 3U);
  EXPECT_EQ(split(mesh, 2.9).mesh.triangle_count(), 4U);
  EXPECT_EQ(split(mesh, 4.5).mesh.positions.back(), Vec3(2, 1.5, 0));
}

TEST(SplitEdges, OfTrianglesWithoutArea) {
  const Mesh line = {{{0, 0, 0}, {1, 0, 0}, {0.3, 0, 0}}, {{0, 1, 2}}};
  EXPECT_LE(longest_edge_of(split(line, 0.01).mesh), 0.01);
  expect_split_right(line, split(line, 0.01));
  const Mesh doubled = {{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}};
  EXPECT_LE(longest_edge_of(split(doubled, 0.01).mesh), 0.01);
  const Mesh point = {{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {{0, 1, 2}}};
  EXPECT_EQ(split(point, 1e-9).mesh.triangles, point.triangles);
}

Mesh needles(double width) {
  Mesh mesh;
  for (std::uint64_t n = 0; n < 100; ++n) {
    const Vec3 at = random_point(1, 3 * n);
    const Vec3 along = random_point(1, 3 * n + 1);
    const Vec3 aside = random_point(1, 3 * n + 2, width);
    const auto first = static_cast<VertexId>(mesh.vertex_count());
    mesh.positions.insert(mesh.positions.end(),
                          {at, at + along, at + along * random_unit(2, n) + aside});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

// Edges a billion times as long as they may be. All are halved once more until there are too many
// vertices, so no part of the mesh is coarser than another.
TEST(SplitEdges, EndsNearItsLimitOfVertices) {
  for (const std::size_t most : {100U, 1000U, 10000U}) {
    for (const double width : {0.0, 1e-6, 1e-3, 1.0}) {
      const Mesh mesh = needles(width);
      const SplitMesh result = split(mesh, 1e-9, most);
      EXPECT_LT(result.mesh.vertex_count(), std::max<std::size_t>(4 * most, 301)) << width;
      EXPECT_GE(result.mesh.vertex_count(), most) << width;
      expect_split_right(mesh, result);
    }
  }
}

// A needle gets no more pieces than its edges have, for there is nothing between them.
TEST(SplitEdges, OfNeedlesStayNeedles) {
  for (const double width : {0.0, 1e-9, 1e-4}) {
    const Mesh mesh = needles(width);
    for (const double longest : {0.3, 0.05, 0.01, 1e-3}) {
      const SplitMesh result = split(mesh, longest, 10'000'000);
      EXPECT_LE(longest_edge_of(result.mesh), longest);
      double edges = 0;
      for (std::size_t v = 0; v < mesh.vertex_count(); v += 3) {
        const Vec3* p = &mesh.positions[v];
        edges += norm(p[1] - p[0]) + norm(p[2] - p[1]) + norm(p[0] - p[2]);
      }
      EXPECT_LT(static_cast<double>(result.mesh.vertex_count()), 300 + 2 * edges / longest);
    }
    expect_split_right(mesh, split(mesh, 0.02));
  }
}

// Its facets are triangles with two long edges. Closed at the ends.
Mesh long_tube(VertexId facets, double length) {
  Mesh tube;
  tube.positions = {{0, 0, 0}, {0, 0, length}};
  for (VertexId i = 0; i < facets; ++i) {
    const double angle = 2 * std::numbers::pi * i / facets;
    tube.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    tube.positions.emplace_back(std::cos(angle), std::sin(angle), length);
    const VertexId a = 2 + 2 * i;
    const VertexId b = 2 + 2 * ((i + 1) % facets);
    tube.triangles.insert(tube.triangles.end(),
                          {{a, b, b + 1}, {a, b + 1, a + 1}, {0, b, a}, {1, a + 1, b + 1}});
  }
  return tube;
}

TEST(SplitEdges, OfALongTube) {
  const Mesh tube = long_tube(300, 20);
  const SplitMesh result = split(tube, 0.2);
  EXPECT_LE(longest_edge_of(result.mesh), 0.2);
  EXPECT_LT(result.mesh.vertex_count(), 300 * 2 * 128 + 5000U);
  expect_split_right(tube, result);
}

// Splitting must not use up the limit of vertices before edges are short.
TEST(SplitEdges, LeavesRegularRemeshesOfALongTube) {
  RemeshOptions options;
  options.vertex_count = 300;
  const Remesh made = remesh(long_tube(400, 10), options, reference_runtime());
  EXPECT_EQ(made.mesh.vertex_count(), 300U);
  EXPECT_TRUE(made.has_input_topology());
  EXPECT_LT(made.energy, 1.02 * made.energy_of_hexagonal_tiling);
}

// Where coordinates are too coarse for middles, edges stay as they are.
TEST(SplitEdges, EndsWhereCoordinatesDo) {
  const Mesh far = {{{1e15, 0, 0}, {1e15 + 1, 0, 0}, {1e15, 1, 0}}, {{0, 1, 2}}};
  EXPECT_LT(split(far, 1e-3, 100'000).mesh.vertex_count(), 100'000U);
  const Mesh edge = {{{1e15, 0, 0}, {1e15 + 0.125, 0, 0}, {1e15, 1e-9, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(split(edge, 1e-3).mesh.triangles, edge.triangles);
  const Mesh huge = {{{-1e75, 0, 0}, {1e75, 0, 0}, {0, 1e75, 0}}, {{0, 1, 2}}};
  EXPECT_LT(split(huge, 1e-75, 10'000).mesh.vertex_count(), 40'000U);
}

}  // namespace
}  // namespace geolloyd
