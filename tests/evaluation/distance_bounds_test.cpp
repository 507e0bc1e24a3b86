// Bounds of distances that are known, or that dense sampling finds.
#include "tools/evaluation/distances/distance_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/mesh/mesh_measure.h"
#include "core/mesh/subdivide.h"
#include "core/shapes/shapes.h"
#include "geolloyd/errors.h"
#include "parallel/threads/scheduler.h"
#include "tools/evaluation/distances/piece_cuts.h"
#include "tools/evaluation/distances/point_queries.h"
#include "tools/evaluation/distances/surface_distance.h"

namespace geolloyd {
namespace {

SurfaceDistanceBounds bounds_of(const Mesh& first, const Mesh& second, double tolerance = 0) {
  Scheduler scheduler(2);
  return certify_distance(scheduler, first, second, tolerance);
}

Mesh placed(Mesh mesh, const Vec3& by, double scale = 1) {
  for (Vec3& p : mesh.positions) p = scale * p + by;
  return mesh;
}

// `rounding`: of the expected value itself.
void expect_around(const DistanceBounds& bounds, double expected, double rounding = 1e-14) {
  EXPECT_LE(bounds.lower, expected * (1 + rounding));
  EXPECT_GE(bounds.upper, expected * (1 - rounding));
  EXPECT_LE(bounds.upper - bounds.lower, 0.01 * bounds.lower + 1e-11);
}

// A mesh of triangles whose corners are no one else's.
Mesh soup_of(const std::vector<TriangleCorners>& triangles) {
  Mesh mesh;
  for (const TriangleCorners& corner : triangles) {
    const auto first = static_cast<VertexId>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), corner.begin(), corner.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TEST(DistanceBounds, HoldTheDistanceOfParallelPlanes) {
  const Mesh low = irregular_plane(500, 1);
  const SurfaceDistanceBounds found = bounds_of(low, placed(irregular_plane(700, 2), {0, 0, 0.25}));
  expect_around(found.from_first, 0.25);
  expect_around(found.from_second, 0.25);
}

// The inner one is convex: so the farthest points are corners of the outer one, above its own.
TEST(DistanceBounds, HoldTheDistanceOfConcentricSpheres) {
  Mesh small = icosphere(5'000);
  for (Vec3& p : small.positions) p = normalized(p);
  expect_around(bounds_of(placed(small, {0, 0, 0}, 1.5), small).from_first, 0.5, 1e-12);
}

TEST(DistanceBounds, HoldTheDistanceOfConcentricCubes) {
  const Mesh small = cube(500);
  const BoundingBox box = bounding_box(small.positions);
  const double side = box.extent().x();
  const Mesh around = placed(cube(300), -0.5 * box.middle(), 1.5);
  const SurfaceDistanceBounds found = bounds_of(around, small);
  expect_around(found.from_first, std::sqrt(3) * side / 4, 1e-12);
  expect_around(found.from_second, side / 4, 1e-12);
  expect_around(found.two_sided(), std::sqrt(3) * side / 4, 1e-12);
}

// The farthest point is in the middle of a hole, where no vertex is and hardly a sample.
TEST(DistanceBounds, FindWhatSamplesMiss) {
  const Vec3 a(0.5, 0.5, 0);
  const Vec3 b(0.503, 0.5, 0);
  const Vec3 c(0.5, 0.504, 0);
  const Vec3 p(0, 0, 0);
  const Vec3 q(1, 0, 0);
  const Vec3 r(0, 1, 0);
  const Vec3 s(1, 1, 0);
  const Mesh whole = soup_of({{p, q, r}, {q, s, r}});
  const Mesh with_hole =
      soup_of({{p, q, a}, {q, b, a}, {q, s, b}, {s, c, b}, {s, r, c}, {r, p, c}, {p, a, c}});
  const double radius = 0.001;  // of the circle in a triangle with sides of 3, 4 and 5
  Scheduler scheduler(2);
  EXPECT_LT(measure_distance(scheduler, whole, with_hole, 1'000).two_sided().largest, radius / 2);
  const SurfaceDistanceBounds found = bounds_of(whole, with_hole);
  expect_around(found.from_first, radius, 1e-9);
  EXPECT_LE(found.from_second.upper, 1e-11);
}

TEST(DistanceBounds, AreNothingOfTheSameTriangles) {
  const Mesh mesh = creature(2'000, 1);
  Mesh turned = mesh;
  std::reverse(turned.triangles.begin(), turned.triangles.end());
  for (Triangle& t : turned.triangles) std::rotate(t.begin(), t.begin() + 1, t.end());
  const DistanceBounds found = bounds_of(mesh, turned).two_sided();
  EXPECT_EQ(found.lower, 0);
  EXPECT_EQ(found.upper, 0);
}

TEST(DistanceBounds, AreHardlyMoreOfTheSameSurface) {
  const Mesh mesh = torus(2'000, 1);
  EXPECT_LE(bounds_of(mesh, subdivide_midpoint(mesh)).two_sided().upper, 1e-10);
  EXPECT_LE(bounds_of(irregular_plane(500, 1), irregular_plane(5'000, 2)).two_sided().upper, 1e-10);
}

double largest_of_vertices(const Mesh& mesh, const ClosestPoint& closest) {
  double largest = 0;
  for (const Vec3& p : mesh.positions) largest = std::max(largest, closest.find(p).distance);
  return largest;
}

double longest_edge(const Mesh& mesh) {
  double longest = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    for (const auto& [u, v] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      longest = std::max(longest, norm(mesh.positions[u] - mesh.positions[v]));
    }
  }
  return longest;
}

// No point is farther from a vertex than the longest edge is long.
TEST(DistanceBounds, HoldWhatDenseSamplesFind) {
  const auto expect_one_way = [](const DistanceBounds& bounds, Mesh from, const Mesh& to) {
    while (from.triangle_count() < 300'000) from = subdivide_midpoint(from);
    const double dense = largest_of_vertices(from, ClosestPoint(to, 1));
    EXPECT_GE(bounds.upper, dense);
    EXPECT_LE(bounds.lower, dense + longest_edge(from));
    EXPECT_LE(bounds.upper, 1.01 * bounds.lower);
  };
  const Mesh fine = creature(3'000, 1);
  const Mesh coarse = creature(400, 1);
  const SurfaceDistanceBounds found = bounds_of(fine, coarse);
  expect_one_way(found.from_first, fine, coarse);
  expect_one_way(found.from_second, coarse, fine);
}

Vec3 random_place(std::uint64_t n) {
  return {random_unit(1, 3 * n), random_unit(1, 3 * n + 1), random_unit(1, 3 * n + 2)};
}

// Thin ones, segments and points among them.
Mesh random_triangles(std::size_t count, std::uint64_t first) {
  std::vector<TriangleCorners> triangles;
  for (std::uint64_t n = first; n < first + count; ++n) {
    const Vec3 a = random_place(5 * n);
    const Vec3 b = a + 0.3 * random_place(5 * n + 1);
    const double width = n % 4 == 0 ? 0 : n % 4 == 1 ? 1e-9 : 0.2;
    const Vec3 c = a + 0.4 * (b - a) + width * random_place(5 * n + 2);
    triangles.push_back(n % 7 == 0 ? TriangleCorners{a, a, a} : TriangleCorners{a, b, c});
  }
  return soup_of(triangles);
}

TEST(DistanceBounds, HoldForTrianglesOfEveryShape) {
  for (std::uint64_t first = 0; first < 2'000; first += 200) {
    const Mesh from = random_triangles(40, first);
    const Mesh to = random_triangles(40, first + 100);
    const SurfaceDistanceBounds found = bounds_of(from, to);
    Mesh dense = from;
    for (int i = 0; i < 6; ++i) dense = subdivide_midpoint(dense);
    const double sampled = largest_of_vertices(dense, ClosestPoint(to, 1));
    EXPECT_GE(found.from_first.upper, sampled);
    EXPECT_LE(found.from_first.lower, sampled + 0.005);
    expect_around(found.from_first, std::max(found.from_first.lower, sampled));
  }
}

TEST(DistanceBounds, AreAsCloseAsAToleranceAsksFor) {
  const Mesh fine = creature(3'000, 1);
  const Mesh coarse = creature(400, 1);
  const DistanceBounds plain = bounds_of(fine, coarse).two_sided();
  const DistanceBounds found = bounds_of(fine, coarse, 3 * plain.upper).two_sided();
  EXPECT_LE(found.upper - found.lower, 0.03 * plain.upper);
  EXPECT_LE(found.lower, plain.upper);
  EXPECT_GE(found.upper, plain.lower);
}

TEST(DistanceBounds, DoNotDependOnTheNumberOfThreads) {
  const Mesh first = creature(3'000, 1);
  const Mesh second = creature(1'000, 2);
  Scheduler one(1);
  const SurfaceDistanceBounds expected = certify_distance(one, first, second, 0);
  for (const std::size_t threads : {2U, 3U, 8U}) {
    Scheduler scheduler(threads);
    const SurfaceDistanceBounds found = certify_distance(scheduler, first, second, 0);
    EXPECT_EQ(found.from_first.lower, expected.from_first.lower);
    EXPECT_EQ(found.from_first.upper, expected.from_first.upper);
    EXPECT_EQ(found.from_second.lower, expected.from_second.lower);
    EXPECT_EQ(found.from_second.upper, expected.from_second.upper);
  }
}

// Powers of two, so that the planes are what they are meant to be.
TEST(DistanceBounds, HoldFarFromTheOriginAndAtEveryScale) {
  const Mesh low = cube(300);
  for (const double scale : {0x1p-600, 0x1p-30, 1.0, 0x1p200}) {
    SCOPED_TRACE(scale);
    const Mesh first = placed(low, {0, 0, 0}, scale);
    const Mesh second = placed(low, {0, 0, 8 * scale}, scale);
    const DistanceBounds found = bounds_of(first, second).two_sided();
    const double expected = 8 * scale;
    EXPECT_LE(found.lower, expected);
    EXPECT_GE(found.upper, expected);
    EXPECT_LE(found.upper - found.lower, 0.01 * expected);
  }
  const Mesh corner = soup_of({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}});
  const Vec3 far(0x1p30, -0x1p30, 0x1p30);
  const DistanceBounds found =
      bounds_of(placed(corner, far), placed(corner, far + Vec3(0, 0, 0x1p-12))).two_sided();
  EXPECT_LE(found.lower, 0x1p-12);
  EXPECT_GE(found.upper, 0x1p-12);
  EXPECT_LE(found.upper - found.lower, 0.01 * 0x1p-12);
}

double area_of(const TriangleCorners& corner) {
  return norm(cross(corner[1] - corner[0], corner[2] - corner[0])) / 2;
}

// However the walls run, pieces make up the whole and a wall has all of a piece on one side.
TEST(PieceCuts, LoseNothing) {
  for (std::uint64_t n = 0; n < 500; ++n) {
    const SurfacePiece whole{
        {random_place(6 * n), random_place(6 * n + 1), random_place(6 * n + 2)}};
    const TriangleCorners near = {random_place(6 * n + 3), random_place(6 * n + 4),
                                  random_place(6 * n + 5)};
    std::vector<SurfacePiece> pieces;
    std::vector<Vec3> corners;
    cut(whole, near, 1e-14, pieces, corners);
    double area = 0;
    for (const SurfacePiece& piece : pieces) area += area_of(piece.corner);
    EXPECT_NEAR(area, area_of(whole.corner), 1e-13);
    EXPECT_GE(pieces.size(), 2U);
    EXPECT_LE(pieces.size(), 3U);
    EXPECT_GE(corners.size(), 1U);
  }
}

// Along the diagonal of a square: two pieces, and no more corner than that of the cut.
TEST(PieceCuts, RunAlongWalls) {
  const SurfacePiece whole{{Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, 1, 1)}};
  const TriangleCorners near = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  std::vector<SurfacePiece> pieces;
  std::vector<Vec3> corners;
  cut(whole, near, 1e-14, pieces, corners);
  ASSERT_EQ(corners.size(), 1U);
  EXPECT_LT(norm(corners[0] - Vec3(0.5, 0.5, 1)), 1e-15);
  EXPECT_EQ(pieces.size(), 2U);
}

TEST(DistanceBounds, NeedTwoSurfaces) {
  EXPECT_THROW(bounds_of(Mesh{}, cube(12)), InvalidInput);
  EXPECT_THROW(bounds_of(cube(12), Mesh{}), InvalidInput);
}

}  // namespace
}  // namespace geolloyd
