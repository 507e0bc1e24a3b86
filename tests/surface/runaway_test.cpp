// Remeshes whose work could run away, or whose triangles could vanish.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/mesh/mesh_measure.h"
#include "core/repair/crossings.h"
#include "core/surface/result/remesh.h"
#include "core/surface/sizing/recipe.h"
#include "core/surface/substrate/split_needles.h"
#include "geolloyd/runtime.h"
#include "geolloyd/threads.h"
#include "parallel/threads/scheduler.h"
#include "tests/support/needles.h"
#include "tests/support/odd_surfaces.h"
#include "tests/support/shared_meshes.h"
#include "tests/support/walked_topology.h"

namespace geolloyd {
namespace {

double area_of(const Mesh& mesh) {
  const auto areas = triangle_areas(mesh, {});
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

std::size_t fine_vertices(const Remesh& remesh) {
  std::size_t most = 0;
  for (const SurfaceStep& step : remesh.steps) most = std::max(most, step.mesh_vertices);
  return most;
}

Remesh remesh_of(const Mesh& mesh, std::size_t vertices, Runtime& runtime) {
  RemeshOptions options;
  options.vertex_count = vertices;
  return make_remesh(mesh, find_edges(mesh), options, runtime);
}

TEST(PiecesOfLongEdges, AreTheSameByAllThreads) {
  Scheduler three(3);
  const Mesh plate = needle_plate(100'000, 0.1);
  EXPECT_EQ(pieces_of_long_edges(plate, {}, 0.01), pieces_of_long_edges(plate, {}, 0.01, three));
}

// What is split, and so all that comes after, is bounded by what was given and asked for.
TEST(RemeshOfNeedles, IsBoundedInItsWork) {
  for (const Mesh& mesh : {needle_plate(20'000, 0.05), needle_cylinder(3000, 0.01)}) {
    for (const std::size_t vertices : {100U, 1000U}) {
      const Remesh remesh = remesh_of(mesh, vertices, all_threads());
      EXPECT_LE(fine_vertices(remesh), 64 * vertices + 2 * mesh.vertex_count());
      EXPECT_TRUE(remesh.has_input_topology());
      EXPECT_EQ(walk_topology(remesh.mesh).flaw, "");
      EXPECT_LE(remesh.mesh.vertex_count(), 2 * vertices);
    }
  }
}

TEST(RemeshOfNeedles, HasALimitWhereNothingHelps) {
  const Mesh mesh = loose_needles(300);
  const Remesh remesh = remesh_of(mesh, 100, all_threads());
  EXPECT_LE(fine_vertices(remesh), vertex_limit_of_remesh(mesh, 100));
  EXPECT_TRUE(remesh.has_input_topology());
}

// Also of triangles far from those that the needles were.
TEST(RemeshOfNeedles, HasItsPlacesOnTheInput) {
  const Mesh mesh = needle_plate(20'000, 0.05);
  RemeshOptions options;
  options.vertex_count = 300;
  options.fit = false;
  const Remesh remesh = make_remesh(mesh, find_edges(mesh), options, all_threads());
  double area = 0;
  for (std::size_t v = 0; v < remesh.places.size(); ++v) {
    const auto& [triangle, barycentric] = remesh.places[v];
    ASSERT_LT(triangle, mesh.triangle_count());
    Vec3 p = Vec3::Zero();
    for (std::size_t c = 0; c < 3; ++c) {
      p += barycentric[c] * mesh.positions[mesh.triangles[triangle][c]];
    }
    EXPECT_LE(norm(p - remesh.mesh.positions[v]), 1e-9);
  }
  area = area_of(remesh.mesh);
  EXPECT_NEAR(area, 0.05, 1e-4);
}

TEST(RemeshOfNeedles, HasTheSameBitsByEveryEngine) {
  const Mesh mesh = needle_cylinder(3000, 0.01);
  const Remesh reference = remesh_of(mesh, 200, reference_runtime());
  for (const std::size_t threads : {1U, 2U, 5U}) {
    Scheduler scheduler(threads);
    Threads runtime(scheduler);
    const Remesh remesh = remesh_of(mesh, 200, runtime);
    EXPECT_EQ(remesh.fingerprint, reference.fingerprint);
    EXPECT_EQ(remesh.mesh.positions, reference.mesh.positions);
  }
}

TEST(RemeshOfNeedles, OfATwistedPairIsBounded) {
  const Mesh mesh = hard_mesh("twin_needles.obj");
  if (mesh.triangles.empty()) GTEST_SKIP() << "no twin_needles.obj";
  const Remesh remesh = remesh_of(mesh, 100, all_threads());
  EXPECT_LE(fine_vertices(remesh), 20'000U);
  EXPECT_TRUE(remesh.has_input_topology());
}

// There the creases of the strands would take ten times the vertices that were asked for.
TEST(RemeshOfNeedles, LeavesOutCreasesThatTakeMostVertices) {
  const Mesh mesh = hard_mesh("twin_needles.obj");
  if (mesh.triangles.empty()) GTEST_SKIP() << "no twin_needles.obj";
  const Remesh remesh = remesh_of(mesh, 2000, all_threads());
  EXPECT_TRUE(remesh.creases_left_out);
  EXPECT_TRUE(remesh.feature_edges.empty());
  EXPECT_LT(remesh.mesh.vertex_count(), 16'000U);
  EXPECT_TRUE(remesh.has_input_topology());
}

// The n-th question of a remesh is answered with "stop", for each n: from there on it may ask a few
// times only, and has a result.
TEST(RemeshOfNeedles, HearsAnInterruptInEachStage) {
  const Mesh mesh = needle_cylinder(3000, 0.001);  // far thinner than its triangles are to be
  std::size_t asked = 0;
  RemeshOptions options;
  options.vertex_count = 100;
  options.progress = [&](const RemeshProgress&) { return ++asked > 0; };
  const MeshEdges edges = find_edges(mesh);
  make_remesh(mesh, edges, options, all_threads());
  const std::size_t all = asked;
  EXPECT_GT(all, 20U);
  for (std::size_t stop = 1; stop < all; stop += 1 + all / 10) {
    asked = 0;
    options.progress = [&](const RemeshProgress& progress) {
      EXPECT_TRUE(progress.sites == 0 || progress.place(0).allFinite());
      return ++asked < stop;
    };
    const Remesh remesh = make_remesh(mesh, edges, options, all_threads());
    EXPECT_LE(asked, stop + 1) << stop;
    EXPECT_TRUE(remesh.interrupted);
    EXPECT_FALSE(remesh.mesh.triangles.empty());
  }
}

double flattest_of(const Mesh& mesh) {
  double least = 1;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto& p = mesh.positions;
    least = std::min(least, flatness(p[a], p[b], p[c]));
  }
  return least;
}

void expect_area_everywhere(const Mesh& mesh, std::size_t vertices) {
  SCOPED_TRACE(std::to_string(vertices) + " vertices");
  const Remesh remesh = remesh_of(mesh, vertices, all_threads());
  EXPECT_TRUE(remesh.has_input_topology());
  EXPECT_EQ(walk_topology(remesh.mesh).flaw, "");
  EXPECT_GT(flattest_of(remesh.mesh), 1e-6);
}

TEST(Crossings, AreTheSameByAllThreads) {
  Mesh mesh = icosphere(2000);
  append(mesh, moved(mesh, {0.1, 0.2, 0.3}));
  Scheduler three(3);
  const std::vector<TrianglePair> crossings = find_crossings(mesh, three);
  EXPECT_GT(crossings.size(), 100U);
  EXPECT_EQ(crossings, find_crossings(mesh));
}

// The fit and the glides move vertices that share a thin wall. A few triangles are folded at a
// corner of the dual already, and stay so.
TEST(RemeshOfThinWalls, HasNoMoreTrianglesThatCrossThanItsDual) {
  const Mesh mesh = hard_mesh("box_ADIS16480.stl");
  if (mesh.triangles.empty()) GTEST_SKIP() << "no box_ADIS16480.stl";
  RemeshOptions options;
  options.vertex_count = 2000;
  const auto crossings = [&](bool fit) {
    options.fit = fit;
    return find_crossings(make_remesh(mesh, find_edges(mesh), options, all_threads()).mesh).size();
  };
  const std::size_t of_dual = crossings(false);
  EXPECT_LE(of_dual, 9U);
  EXPECT_LE(crossings(true), of_dual);
}

// Sites on the two sides of a slit are in one place, and three of one side in a line.
TEST(RemeshWithASlit, HasNoTriangleWithoutArea) {
  struct Case {
    std::uint32_t cells, length;
    std::size_t vertices;
  };
  for (const auto& [cells, length, vertices] :
       {Case{12, 4, 64}, Case{12, 6, 30}, Case{20, 4, 150}, Case{20, 6, 100}, Case{20, 10, 30},
        Case{20, 14, 16}, Case{40, 10, 100}, Case{40, 10, 150}, Case{40, 14, 50}}) {
    SCOPED_TRACE(std::to_string(cells) + " cells, slit of " + std::to_string(length));
    expect_area_everywhere(plane_with_slit(cells, length), vertices);
  }
}

// Three sites for its boundary, evenly spread, may all be on the longest edge.
TEST(RemeshOfALooseTriangle, HasNoTriangleWithoutArea) {
  for (const double height : {0.01, 0.1, 0.3}) {
    Mesh mesh = icosphere(2000);
    const auto first = static_cast<VertexId>(mesh.vertex_count());
    for (const Vec3& p : {Vec3(3, 0, 0), Vec3(3.04, 0, 0), Vec3(3.03, 0.04 * height, 0)}) {
      mesh.positions.push_back(p);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    const Remesh remesh = remesh_of(mesh, 100, all_threads());
    EXPECT_TRUE(remesh.has_input_topology()) << height;
    EXPECT_GT(flattest_of(remesh.mesh), 0.005 * height) << height;
  }
}

TEST(RemeshWithASlit, OfACamelHasNoTriangleWithoutArea) {
  const Mesh mesh = hard_mesh("camel_b.obj");
  if (mesh.triangles.empty()) GTEST_SKIP() << "no camel_b.obj";
  for (const std::size_t vertices : {300U, 2000U}) expect_area_everywhere(mesh, vertices);
}

// Places for sites where cells do not meet as they should are on curves, which have no room.
TEST(RemeshOfWhatWasCutApart, IsAManifold) {
  const auto check = [](const Mesh& mesh, std::size_t vertices) {
    const Remesh remesh = remesh_of(mesh, vertices, all_threads());
    EXPECT_EQ(walk_topology(remesh.mesh).flaw, "");
    EXPECT_TRUE(remesh.has_input_topology());
  };
  for (const std::uint64_t random_seed : {1U, 5U, 6U, 11U, 13U, 17U}) {
    SCOPED_TRACE(random_seed);
    check(plane_with_fins_and_holes(24, 200, 60, random_seed), 30);
  }
  for (const std::size_t vertices : {4U, 10U}) {
    check(plane_with_fins_and_holes(24, 0, 100, 26), vertices);
  }
}

TEST(RemeshOfWhatWasCutApart, IsAManifoldOfABunny) {
  const Mesh mesh = hard_mesh("bunny_nonmanifold.ply");
  if (mesh.triangles.empty()) GTEST_SKIP() << "no bunny_nonmanifold.ply";
  const Remesh remesh = remesh_of(mesh, 300, all_threads());
  EXPECT_EQ(walk_topology(remesh.mesh).flaw, "");
  EXPECT_TRUE(remesh.has_input_topology());
}

}  // namespace
}  // namespace geolloyd
