#include "core/mesh/mesh_topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "core/shapes/shapes.h"
#include "tests/support/random_graph.h"
#include "tests/support/topology.h"

namespace geolloyd {
namespace {

Mesh soup(std::size_t vertices, std::vector<Triangle> triangles) {
  return {std::vector<Vec3>(vertices, Vec3::Zero()), std::move(triangles)};
}

using Parts = std::vector<PartTopology>;

TEST(MeshTopology, KnowsTheSimplestSurfaces) {
  EXPECT_EQ(topology_of(icosphere(100)).parts, (Parts{{2, 0}}));
  EXPECT_EQ(topology_of(torus(100, 1)).parts, (Parts{{0, 0}}));
  EXPECT_EQ(topology_of(irregular_plane(100, 1)).parts, (Parts{{1, 1}}));
  // A ring of six triangles: two boundaries.
  const MeshTopology ring =
      topology_of(soup(6, {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}, {2, 0, 5}, {0, 3, 5}}));
  EXPECT_EQ(ring.parts, (Parts{{0, 2}}));
  EXPECT_TRUE(ring.is_manifold());
  EXPECT_EQ(ring.inconsistent_edges, 0U);
}

TEST(MeshTopology, TellsPartsApart) {
  Mesh both = icosphere(100);
  const auto shift = static_cast<VertexId>(both.vertex_count());
  const Mesh plane = irregular_plane(10, 1);
  both.positions.insert(both.positions.end(), plane.positions.begin(), plane.positions.end());
  for (const Triangle& t : plane.triangles) {
    both.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
  both.positions.emplace_back(0, 0, 0);  // of no triangle
  const MeshTopology topology = topology_of(both);
  EXPECT_EQ(topology.parts, (Parts{{1, 1}, {2, 0}}));
  EXPECT_EQ(topology.total(), (PartTopology{3, 1}));
}

TEST(MeshTopology, FindsWhereItIsNoManifold) {
  const MeshTopology bow_tie = topology_of(soup(5, {{0, 1, 2}, {0, 3, 4}}));
  EXPECT_EQ(bow_tie.non_manifold_vertices, 1U);
  EXPECT_EQ(bow_tie.non_manifold_edges, 0U);
  EXPECT_EQ(bow_tie.parts, (Parts{{1, 2}}));
  const MeshTopology book = topology_of(soup(5, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}));
  EXPECT_EQ(book.non_manifold_edges, 1U);
  const MeshTopology turned = topology_of(soup(4, {{0, 1, 2}, {0, 1, 3}}));
  EXPECT_EQ(turned.inconsistent_edges, 1U);
  EXPECT_TRUE(turned.is_manifold());
}

// The definition: the triangles at a vertex, joined where they share an edge at it, are connected.
bool is_broken(const Mesh& mesh, VertexId v) {
  std::vector<Triangle> around;
  for (const Triangle& t : mesh.triangles) {
    if (has_three_vertices(t) && std::count(t.begin(), t.end(), v) > 0) around.push_back(t);
  }
  if (around.empty()) return false;
  const auto touch = [v](const Triangle& a, const Triangle& b) {
    return std::any_of(a.begin(), a.end(),
                       [&](VertexId w) { return w != v && std::count(b.begin(), b.end(), w) > 0; });
  };
  std::vector<bool> met(around.size(), false);
  const std::function<void(std::size_t)> walk = [&](std::size_t i) {
    if (met[i]) return;
    met[i] = true;
    for (std::size_t j = 0; j < around.size(); ++j) {
      if (touch(around[i], around[j])) walk(j);
    }
  };
  walk(0);
  return std::count(met.begin(), met.end(), false) > 0;
}

TEST(MeshTopology, AgreesWithTheDefinitionOnRandomSoups) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    std::vector<Triangle> triangles;
    const std::uint32_t count = 1 + random_number(seed, 0, 12);
    for (std::uint32_t i = 0; i < count; ++i) {
      triangles.push_back({random_number(seed, 3 * i + 1, 8), random_number(seed, 3 * i + 2, 8),
                           random_number(seed, 3 * i + 3, 8)});
    }
    const Mesh mesh = soup(8, triangles);
    std::size_t broken = 0;
    for (VertexId v = 0; v < 8; ++v) broken += is_broken(mesh, v) ? 1 : 0;
    EXPECT_EQ(topology_of(mesh).non_manifold_vertices, broken) << seed;
  }
}

}  // namespace
}  // namespace geolloyd
