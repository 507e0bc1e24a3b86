#include "core/dual/dual_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>
#include <set>

#include "core/dual/seed_insertion.h"
#include "core/graph/components.h"
#include "core/lloyd/relaxation.h"
#include "core/mesh/mesh_measure.h"
#include "core/regions/region_borders.h"
#include "core/shapes/shapes.h"
#include "tests/regions/ground.h"
#include "tests/support/graph_kinds.h"
#include "tests/support/random_graph.h"

namespace geolloyd {
namespace {

// A tube of 3 x length quadrilaterals, open at both ends.
Mesh tube(VertexId length) {
  Mesh mesh;
  for (VertexId i = 0; i <= length; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double angle = 2 * std::numbers::pi * j / 3;
      mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0.5 * i);
    }
  }
  for (VertexId i = 0; i < length; ++i) {
    for (VertexId j = 0; j < 3; ++j) {
      const VertexId a = 3 * i + j;
      const VertexId b = 3 * i + (j + 1) % 3;
      mesh.triangles.push_back({a, b, b + 3});
      mesh.triangles.push_back({a, b + 3, a + 3});
    }
  }
  return mesh;
}

// Every third triangle the other way round.
Mesh turned(Mesh mesh) {
  for (std::size_t t = 0; t < mesh.triangle_count(); t += 3) {
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
  return mesh;
}

// A strip of quadrilaterals, two of them wide, closed with a half turn.
Mesh moebius_strip_of(VertexId length) {
  Mesh mesh;
  for (VertexId i = 0; i < length; ++i) {
    const double angle = 2 * std::numbers::pi * i / length;
    for (const double side : {-0.4, 0.0, 0.4}) {
      const double radius = 1 + side * std::cos(angle / 2);
      mesh.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                  side * std::sin(angle / 2));
    }
  }
  for (VertexId i = 0; i < length; ++i) {
    for (VertexId j = 0; j < 2; ++j) {
      const bool closes = i + 1 == length;
      const VertexId next = closes ? 0 : 3 * (i + 1);
      const VertexId c = next + (closes ? 2 - j : j);
      const VertexId d = next + (closes ? 1 - j : j + 1);
      mesh.triangles.push_back({3 * i + j, c, d});
      mesh.triangles.push_back({3 * i + j, d, 3 * i + j + 1});
    }
  }
  return mesh;
}

std::vector<Triangle> rotated(std::vector<Triangle> triangles) {
  for (Triangle& t : triangles)
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

TEST(Dual, OfAllVerticesIsTheMesh) {
  for (const Mesh& mesh : {irregular_plane(60, 1), icosphere(80), tube(4)}) {
    Ground ground(mesh, GraphKind::vertex);
    std::vector<NodeId> seeds = ground.mesh_graph.node_of;  // region r is vertex r
    const DualisedSeeds dualised = ground.dualise(seeds);
    EXPECT_TRUE(dualised.dual.violations.empty());
    EXPECT_EQ(rotated(dualised.dual.triangles), rotated(mesh.triangles));
    EXPECT_EQ(ground.remesh(dualised).positions, mesh.positions);
  }
}

TEST(Dual, NamesTheViolationsOfTooFewSeedsOnASphere) {
  for (const GraphKind kind : all_kinds) {
    Ground ground(icosphere(320), kind);
    const auto count_of = [&](std::size_t seeds, ViolationKind violation) {
      return count(ground.dualise(ground.choose(seeds)).dual.violations, violation);
    };
    EXPECT_EQ(count_of(1, ViolationKind::region), 1U);
    EXPECT_EQ(count_of(1, ViolationKind::isolation), 1U);
    EXPECT_EQ(count_of(2, ViolationKind::region), 0U);
    EXPECT_EQ(count_of(2, ViolationKind::contact), 1U);
    EXPECT_EQ(count_of(2, ViolationKind::isolation), 2U);
  }
  // Three longitudes meet at both poles: a triangle and its back.
  Ground ground(icosphere(320), GraphKind::vertex);
  std::vector<NodeId> seeds;
  for (const double angle : {0.0, 2.0944, 4.1888}) {
    const auto& positions = ground.mesh.positions;
    const Vec3 wanted(std::cos(angle), std::sin(angle), 0);
    const auto nearest = std::min_element(
        positions.begin(), positions.end(),
        [&](const Vec3& a, const Vec3& b) { return norm(a - wanted) < norm(b - wanted); });
    seeds.push_back(
        ground.mesh_graph.node_of[static_cast<std::size_t>(nearest - positions.begin())]);
  }
  const DualMesh dual = ground.dualise(seeds).dual;
  EXPECT_EQ(count(dual.violations, ViolationKind::triple), 1U);
  EXPECT_EQ(dual.violations.size(), 1U);
  EXPECT_EQ(dual.triangles.size(), 2U);
  EXPECT_EQ(dual.back_to_back, 1U);
}

TEST(Dual, WithoutViolationsIsTheSurfaceOverAgain) {
  std::size_t clear = 0;
  for (const Mesh& mesh : {irregular_plane(600, 1), icosphere(320), torus(600, 1), tube(20)}) {
    for (const GraphKind kind : all_kinds) {
      Ground ground(mesh, kind);
      for (std::uint64_t random_seed = 0; random_seed < 12; ++random_seed) {
        const std::size_t seeds = 3 + random_number(random_seed, 0, 50);
        const DualisedSeeds dualised = ground.dualise(ground.choose(seeds, random_seed));
        if (!dualised.dual.violations.empty()) continue;
        ++clear;
        EXPECT_EQ(dualised.dual.repeated + dualised.dual.back_to_back, 0U);
        expect_same_topology(ground.remesh(dualised), mesh);
      }
    }
  }
  EXPECT_GT(clear, 60U);
}

class Repair : public testing::TestWithParam<GraphKind> {};

TEST_P(Repair, MakesAManifoldOfTheSameTopologyFromAnySeeds) {
  const std::vector<Mesh> meshes = {irregular_plane(600, 1), icosphere(320), torus(600, 1),
                                    tube(20), side_by_side(torus(400, 2), irregular_plane(300, 2))};
  for (const Mesh& mesh : meshes) {
    Ground ground(mesh, GetParam());
    for (const std::size_t count : {2U, 3U, 5U, 9U, 40U, 120U}) {
      if (count > ground.mesh_graph.graph.node_count() / 2) continue;
      const std::vector<NodeId> seeds = ground.choose(count, count);
      const DualisedSeeds repaired = ground.repair(seeds);
      EXPECT_TRUE(repaired.dual.violations.empty()) << count;
      std::vector<NodeId> sorted = repaired.seeds;
      std::sort(sorted.begin(), sorted.end());
      EXPECT_EQ(std::adjacent_find(sorted.begin(), sorted.end()), sorted.end());
      expect_same_topology(ground.remesh(repaired), mesh);
    }
  }
}

TEST_P(Repair, WhateverTheOrientations) {
  for (const Mesh& mesh : {turned(icosphere(320)), turned(torus(600, 1)), moebius_strip_of(24)}) {
    Ground ground(mesh, GetParam());
    for (std::uint64_t random_seed = 0; random_seed < 10; ++random_seed) {
      const DualisedSeeds repaired =
          ground.repair(ground.choose(3 + random_number(random_seed, 0, 60), random_seed));
      EXPECT_TRUE(repaired.dual.violations.empty()) << random_seed;
      expect_same_topology(ground.remesh(repaired), mesh);
    }
  }
}

// A part of the mesh without a seed is left out.
TEST_P(Repair, LeavesOutWhatNoSeedReaches) {
  const Mesh sphere = icosphere(320);
  Ground ground(side_by_side(sphere, irregular_plane(300, 2)), GetParam());
  const Components components = connected_components(ground.mesh_graph.graph);
  ASSERT_EQ(components.size(), 2U);
  std::vector<NodeId> seeds;
  for (const NodeId v : ground.choose(12)) {
    if (ground.mesh_graph.position[v].x() < 2) seeds.push_back(v);
  }
  const DualisedSeeds repaired = ground.repair(seeds);
  EXPECT_TRUE(repaired.dual.violations.empty());
  expect_same_topology(ground.remesh(repaired), sphere);
}

TEST_P(Repair, GivesUpWhereThereAreNoNodesLeft) {
  Ground ground({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, GetParam());
  const DualisedSeeds repaired = ground.repair(ground.choose(1));
  // Three vertices suffice for a triangle; one node in the middle of it does not.
  EXPECT_EQ(repaired.dual.violations.empty(), has_vertices(GetParam()));
}

TEST_P(Repair, StopsWhenAsked) {
  Ground ground(torus(600, 1), GetParam());
  const std::vector<NodeId> seeds = ground.choose(2);
  const DualisedSeeds same = ground.repair(seeds, false);
  EXPECT_EQ(same.seeds, seeds);
}

TEST_P(Repair, SurvivesWhatIsNoManifold) {
  // Three sheets at an edge, a bow-tie, a triangle twice, one that names a vertex twice.
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {-1, 0, 0}, {-1, 1, 0}},
                  {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {0, 5, 6}, {0, 5, 6}, {2, 2, 1}}};
  Ground ground(mesh, GetParam());
  const std::size_t parts = connected_components(ground.mesh_graph.graph).size();
  for (std::size_t count = parts; count <= ground.mesh_graph.graph.node_count(); ++count) {
    const DualisedSeeds repaired = ground.repair(ground.choose(count));
    EXPECT_LE(repaired.seeds.size(), ground.mesh_graph.graph.node_count());
    for (const Triangle& t : repaired.dual.triangles) {
      EXPECT_TRUE(has_three_vertices(t));
      for (const VertexId v : t) EXPECT_LT(v, repaired.seeds.size());
    }
  }
}

TEST_P(Repair, InsertionsAreNodesAndNoSeeds) {
  Ground ground(torus(600, 1), GetParam());
  for (const std::size_t count : {1U, 2U, 4U, 8U}) {
    const DualisedSeeds dualised = ground.dualise(ground.choose(count));
    const std::vector<SeedInsertion> insertions =
        find_seed_insertions(dualised.surface, dualised.dual);
    EXPECT_EQ(insertions.empty(), dualised.dual.violations.empty());
    for (const SeedInsertion& insertion : insertions) {
      const NodeId node = node_at(ground.mesh_graph, ground.mesh.vertex_count(), insertion.point);
      ASSERT_LT(node, ground.mesh_graph.graph.node_count());
      EXPECT_EQ(std::count(dualised.seeds.begin(), dualised.seeds.end(), node), 0);
    }
  }
}

// By walking along the triangulation's edges from the seed.
TEST_P(Repair, RegionsAreConnectedOnTheSurface) {
  Ground ground(irregular_plane(800, 3), GetParam());
  const std::vector<NodeId> seeds = ground.choose(60);
  const RegionSurface surface = ground.dualise(seeds).surface;
  std::vector<bool> is_met(surface.region.size(), false);
  for (const NodeId s : seeds)
    is_met[point_of(ground.mesh_graph, ground.mesh.vertex_count(), s)] = true;
  for (bool grows = true; grows;) {
    grows = false;
    for (const Triangle& t : surface.triangles) {
      for (std::size_t c = 0; c < 3; ++c) {
        const PointId a = t[c];
        const PointId b = t[(c + 1) % 3];
        if (surface.region[a] != surface.region[b] || is_met[a] == is_met[b]) continue;
        is_met[a] = is_met[b] = grows = true;
      }
    }
  }
  for (const Triangle& t : surface.triangles) {
    for (const PointId p : t) EXPECT_TRUE(is_met[p]);
  }
  if (GetParam() == GraphKind::vertex || GetParam() == GraphKind::triangle) {
    EXPECT_TRUE(surface.reassigned_points.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(AllGraphs, Repair, testing::ValuesIn(all_kinds));

TEST(Dual, ReachesTheBoundaryAndItsCorners) {
  for (const GraphKind kind : all_kinds) {
    Ground ground(irregular_plane(5000, 1), kind);
    const std::vector<NodeId> seeds =
        relax(ground.mesh_graph.graph, *ground.engine, ground.choose(120), {}).seeds;
    const Mesh remesh = ground.remesh(ground.repair(seeds));
    double area = 0;
    for (const Triangle& t : remesh.triangles) area += triangle_area(remesh, t);
    // A square, to its corners, but for a region so low at the boundary that the ones beside it
    // meet above it: one of them stays away.
    EXPECT_NEAR(area, 1, 0.01);
    std::set<VertexId> inner;
    const MeshEdges edges = find_edges(remesh);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (edges.corners(e).size() != 1) continue;
      for (const VertexId v : edges.ends[e]) {
        const Vec3& p = remesh.positions[v];
        if (std::min({p.x(), p.y(), 1 - p.x(), 1 - p.y()}) > 1e-12) inner.insert(v);
      }
    }
    EXPECT_LE(inner.size(), 1U);
  }
}

// An edge without length has no direction, and so is no turn.
TEST(Dual, GoesToTheNearestBoundaryByAnEdgeWithoutLength) {
  // A strip from y = 0 to y = 1; at (2, 0) its boundary has two vertices in the same place.
  const Mesh mesh{{{0, 0, 0}, {2, 0, 0}, {2, 0, 0}, {4, 0, 0}, {0, 1, 0}, {2, 1, 0}, {4, 1, 0}},
                  {{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 3, 5}, {3, 6, 5}}};
  Ground ground(mesh, GraphKind::vertex);
  const auto& node_of = ground.mesh_graph.node_of;
  const DualisedSeeds dualised = ground.dualise({node_of[0], node_of[3], node_of[5]});
  ASSERT_EQ(dualised.surface.region[1], 2U);
  EXPECT_EQ(ground.remesh(dualised).positions[2], Vec3(2, 1, 0));
}

TEST(Dual, CountsTrianglesThatFaceAway) {
  Ground ground(irregular_plane(600, 1), GraphKind::vertex);
  const std::vector<NodeId> seeds =
      relax(ground.mesh_graph.graph, *ground.engine, ground.choose(20), {}).seeds;
  const DualisedSeeds dualised = ground.repair(seeds);
  std::vector<Vec3> places = ground.remesh(dualised).positions;
  EXPECT_EQ(count_flipped(ground.mesh, dualised.surface, dualised.dual, places), 0U);
  for (Vec3& p : places) p.x() = -p.x();
  EXPECT_EQ(count_flipped(ground.mesh, dualised.surface, dualised.dual, places),
            dualised.dual.triangles.size());
}

TEST(RegionBorders, OfOneRegionIsTheBoundary) {
  for (const GraphKind kind : all_kinds) {
    Ground ground(irregular_plane(500, 1), kind);
    const auto surface = ground.dualise(ground.choose(1)).surface;
    ASSERT_EQ(border_lengths(ground.mesh, surface).size(), 1U);
    EXPECT_NEAR(border_lengths(ground.mesh, surface)[0], 4, 1e-9);
  }
  EXPECT_NEAR(isoperimetric_ratio(1, 4), std::numbers::pi / 4, 1e-12);
  EXPECT_NEAR(isoperimetric_ratio(std::numbers::pi, 2 * std::numbers::pi), 1, 1e-12);
  EXPECT_EQ(isoperimetric_ratio(1, 0), 0);
}

// Cut straight through the middle, whatever the triangles, as far as the graph knows distances.
TEST(RegionBorders, OfTwoHalvesOfASquare) {
  for (const GraphKind kind : all_kinds) {
    Ground ground(irregular_plane(20000, 1), kind);
    const auto nearest = [&](const Vec3& wanted) {
      const auto& positions = ground.mesh_graph.position;
      return static_cast<NodeId>(std::min_element(positions.begin(), positions.end(),
                                                  [&](const Vec3& a, const Vec3& b) {
                                                    return norm(a - wanted) < norm(b - wanted);
                                                  }) -
                                 positions.begin());
    };
    const auto surface = ground.dualise({nearest({0.25, 0.5, 0}), nearest({0.75, 0.5, 0})}).surface;
    for (const double length : border_lengths(ground.mesh, surface)) EXPECT_NEAR(length, 3, 0.06);
  }
}

}  // namespace
}  // namespace geolloyd
