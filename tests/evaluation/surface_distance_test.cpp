#include "tools/evaluation/distances/surface_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/mesh/mesh_measure.h"
#include "core/mesh/subdivide.h"
#include "core/shapes/shapes.h"
#include "geolloyd/errors.h"
#include "tools/evaluation/distances/point_queries.h"
#include "tools/evaluation/distances/surface_samples.h"

namespace geolloyd {
namespace {

SurfaceDistance distance_of(const Mesh& first, const Mesh& second, std::size_t samples = 20'000) {
  Scheduler scheduler(2);
  return measure_distance(scheduler, first, second, samples);
}

Mesh moved(Mesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.positions) p += by;
  return mesh;
}

void expect_all_near(const DistanceFigures& figures, double expected, double tolerance) {
  EXPECT_NEAR(figures.mean, expected, tolerance);
  EXPECT_NEAR(figures.rms, expected, tolerance);
  EXPECT_NEAR(figures.largest, expected, tolerance);
}

TEST(SurfaceDistance, OfParallelPlanesIsTheirDistance) {
  const Mesh low = irregular_plane(500, 1);
  const Mesh high = moved(irregular_plane(700, 2), {0, 0, 0.25});
  const SurfaceDistance found = distance_of(low, high);
  expect_all_near(found.from_first, 0.25, 1e-12);
  expect_all_near(found.from_second, 0.25, 1e-12);
  expect_all_near(found.two_sided(), 0.25, 1e-12);
}

TEST(SurfaceDistance, OfConcentricSpheresIsThatOfTheirRadii) {
  const Mesh small = icosphere(20'000);
  Mesh large = small;
  for (Vec3& p : large.positions) p *= 1.5;
  const SurfaceDistance found = distance_of(small, large);
  // Facets lie up to 0.1 % below the sphere.
  expect_all_near(found.from_first, 0.5, 1e-3);
  expect_all_near(found.from_second, 0.5, 1e-3);
}

TEST(SurfaceDistance, OfAMeshToItselfOrItsSubdivisionIsNothing) {
  const Mesh mesh = torus(2'000, 1);
  expect_all_near(distance_of(mesh, mesh).two_sided(), 0, 1e-14);
  expect_all_near(distance_of(mesh, subdivide_midpoint(mesh)).two_sided(), 0, 1e-14);
}

// Half of a unit square against all of it: points of the other half are 0 to 1/2 away.
TEST(SurfaceDistance, HasTwoDirections) {
  const Mesh whole = irregular_plane(200, 1);
  Mesh half = whole;
  for (Vec3& p : half.positions) p.x() /= 2;
  const SurfaceDistance found = distance_of(half, whole);
  expect_all_near(found.from_first, 0, 1e-14);
  EXPECT_NEAR(found.from_second.mean, 1.0 / 8, 1e-3);
  EXPECT_NEAR(found.from_second.rms, std::sqrt(1.0 / 24), 1e-3);
  EXPECT_NEAR(found.from_second.largest, 0.5, 1e-12);  // at vertices
  EXPECT_EQ(found.two_sided().mean, found.from_second.mean);
}

TEST(SurfaceDistance, IsLargestAtAVertexThatSamplesMiss) {
  Mesh spike = irregular_plane(200, 1);
  spike.positions.insert(spike.positions.end(), {{1, 1, 0}, {1, 1 + 1e-9, 0}, {1, 1, 3}});
  spike.triangles.push_back({121, 122, 123});
  EXPECT_NEAR(distance_of(spike, irregular_plane(200, 1), 100).from_first.largest, 3, 1e-12);
}

// A vertex of no triangle is not part of the surface.
TEST(SurfaceDistance, IgnoresVerticesOfNoTriangle) {
  Mesh mesh = irregular_plane(200, 1);
  mesh.positions.emplace_back(0, 0, 9);
  expect_all_near(distance_of(mesh, irregular_plane(200, 1)).two_sided(), 0, 1e-14);
}

// Every vertex by a query of its own: those left out are no farther away.
TEST(SurfaceDistance, IsAsLargeAsThatOfEachVertexByItself) {
  const Mesh fine = creature(20'000, 1);
  const Mesh coarse = creature(300, 1);
  const ClosestPoint closest(coarse, 1);
  double largest = 0;
  for (const Vec3& p : fine.positions) largest = std::max(largest, closest.find(p).distance);
  Scheduler scheduler(2);
  const MeshEdges edges = find_edges(fine);
  EXPECT_EQ(measure_distance_one_way(scheduler, fine, edges, coarse, 1).largest, largest);
  const DistanceFigures found = measure_distance_one_way(scheduler, fine, edges, coarse, 5'000);
  EXPECT_GE(found.largest, largest);
  EXPECT_LE(found.largest, 1.05 * largest);
}

TEST(SurfaceDistance, DoesNotDependOnTheNumberOfThreads) {
  const Mesh first = torus(2'000, 1);
  const Mesh second = torus(1'000, 2);
  Scheduler one(1);
  const SurfaceDistance expected = measure_distance(one, first, second, 10'001);
  EXPECT_GT(expected.from_first.mean, 0);
  for (const std::size_t threads : {2U, 3U, 8U}) {
    Scheduler scheduler(threads);
    const SurfaceDistance found = measure_distance(scheduler, first, second, 10'001);
    EXPECT_EQ(found.from_first.mean, expected.from_first.mean);
    EXPECT_EQ(found.from_first.rms, expected.from_first.rms);
    EXPECT_EQ(found.from_second.largest, expected.from_second.largest);
  }
}

TEST(SurfaceDistance, NeedsTwoSurfaces) {
  const Mesh plane = irregular_plane(2, 1);
  const Mesh line{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 1, 1}}};
  EXPECT_THROW(distance_of(plane, line), InvalidInput);
  EXPECT_THROW(distance_of(line, plane), InvalidInput);
  EXPECT_THROW(distance_of(Mesh{}, plane), InvalidInput);
}

std::vector<double> areas_of(const Mesh& mesh) {
  std::vector<double> areas;
  for (const Triangle& t : mesh.triangles) areas.push_back(triangle_area(mesh, t));
  return areas;
}

// Triangles of very different areas; cells of equal area get as many points each, all over.
TEST(SurfaceSamples, AreSpreadEvenlyByArea) {
  Mesh mesh = irregular_plane(200, 1);
  for (Vec3& p : mesh.positions) p.x() *= p.x();
  const std::size_t count = 40'000;
  const std::vector<double> areas = areas_of(mesh);
  const SurfaceSamples samples(mesh, areas, count, 1);
  std::vector<double> in_cell(16, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 p = samples.at(i);
    ASSERT_TRUE(p.x() >= 0 && p.x() <= 1 && p.y() >= 0 && p.y() <= 1);
    ++in_cell[static_cast<std::size_t>(std::min(3.0, 4 * p.x()) +
                                       4 * std::floor(std::min(3.0, 4 * p.y())))];
  }
  for (const double n : in_cell) EXPECT_NEAR(n, 2'500, 150);  // three standard deviations
}

// Four similar parts of one triangle, by their points' largest barycentric coordinate.
TEST(SurfaceSamples, AreSpreadEvenlyOverATriangle) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const std::vector<double> areas = areas_of(mesh);
  const SurfaceSamples samples(mesh, areas, 40'000, 1);
  std::vector<double> in_part(4, 0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vec3 p = samples.at(i);
    const double third = 1 - p.x() - p.y();
    ++in_part[p.x() > 0.5 ? 0 : p.y() > 0.5 ? 1 : third > 0.5 ? 2 : 3];
  }
  for (const double n : in_part) EXPECT_NEAR(n, 10'000, 300);
}

}  // namespace
}  // namespace geolloyd
