// The public headers of evaluation and render.
#include <geolloyd/errors.h>
#include <geolloyd/evaluation.h>
#include <geolloyd/render.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "core/shapes/shapes.h"
#include "core/text/file_io.h"
#include "tests/support/spiked_sphere.h"
#include "tests/support/temporary_folder.h"

namespace geolloyd {
namespace {

Tessellation tessellation_of(const Mesh& mesh, std::size_t seeds) {
  RelaxOptions options;
  options.seed_count = seeds;
  return relax(mesh, options);
}

TEST(EvaluationLibrary, TheGroundTruthSpeaksInputIds) {
  const Mesh mesh = icosphere(2000);
  const Tessellation tessellation = tessellation_of(mesh, 12);
  const Evaluation found = evaluate(mesh, tessellation);
  ASSERT_EQ(found.region.size(), mesh.vertex_count());
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    const auto distance_to = [&](RegionId r) {
      return (mesh.positions[v] - mesh.positions[tessellation.regions[r].seed]).squaredNorm();
    };
    for (RegionId r = 0; r < 12; ++r) {
      EXPECT_LE(distance_to(found.region[v]), distance_to(r) * (1 + 1e-12));
    }
  }
  EXPECT_GT(found.node_agreement, 0.8);
  EXPECT_LE(found.energy, found.graph_energy);
  EXPECT_EQ(found.centroid.size(), 12U);
}

TEST(EvaluationLibrary, ConcentricSpheresAreTheirRadiiApart) {
  const Mesh sphere = icosphere(20000);
  Mesh larger = sphere;
  for (Vec3& p : larger.positions) p *= 1.5;
  const double radius = sphere.positions[0].norm();
  const SurfaceDistance distance = measure_distance(sphere, larger, 1000);
  EXPECT_NEAR(distance.two_sided().mean, radius / 2, 1e-3 * radius);
}

TEST(EvaluationLibrary, ClosestPointsOfASphereAreOnTheirRays) {
  const Mesh sphere = icosphere(20000);
  const std::vector<Vec3> points = {{2, 0, 0}, {0, -0.5, 0}, {1, 2, 3}, sphere.positions[7]};
  const std::vector<SurfacePoint> found = closest_points(sphere, points);
  ASSERT_EQ(found.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    Vec3 place = Vec3::Zero();
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      place += found[i].barycentric[c] * sphere.positions[sphere.triangles[found[i].triangle][c]];
      sum += found[i].barycentric[c];
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_LT((place - points[i].normalized()).norm(), 0.02);
  }
}

TEST(EvaluationLibrary, ARemeshWithinAToleranceHasFewVertices) {
  const Mesh sphere = icosphere(3000);
  const ToleranceRemesh made = remesh_within(sphere, 0.1, {});
  ASSERT_FALSE(made.trials.empty());
  const double distance = measure_distance(sphere, made.remesh.mesh, 200'000).two_sided().largest;
  EXPECT_LE(distance, 0.1);
  EXPECT_LT(made.remesh.mesh.vertex_count(), 100U);
  EXPECT_LE(made.bounds.upper, 0.1);
  EXPECT_LE(certify_distance(sphere, made.remesh.mesh, 0.1).two_sided().lower, 0.1);
  EXPECT_LE(made.bounds.lower, made.bounds.upper);
  RemeshOptions stopping;
  stopping.progress = [](const RemeshProgress&) { return false; };
  const ToleranceRemesh stopped = remesh_within(sphere, 1e-9, stopping);
  EXPECT_TRUE(stopped.remesh.interrupted);
  EXPECT_FALSE(stopped.remesh.mesh.triangles.empty());
  EXPECT_TRUE(stopped.trials.empty());
}

// Two thirds more vertices, evenly spread, are too far away.
TEST(EvaluationLibrary, ARemeshWithinAToleranceHasShortEdgesWhereTheyAreNeeded) {
  const Mesh mesh = spiked_sphere();
  constexpr double tolerance = 0.03;
  const std::size_t fewest = remesh_within(mesh, tolerance, {}).remesh.mesh.vertex_count();
  RemeshOptions even;
  even.vertex_count = fewest + 2 * fewest / 3;
  const SurfaceDistance distance = measure_distance(mesh, remesh(mesh, even).mesh, 200'000);
  EXPECT_GT(distance.two_sided().largest, tolerance);
}

TEST(EvaluationLibrary, RefusesWhatMakesNoSense) {
  const Mesh mesh = icosphere(80);
  const Mesh other = icosphere(320);
  const Tessellation tessellation = tessellation_of(mesh, 3);
  const Mesh flat = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
  EXPECT_THROW(evaluate(other, tessellation), InvalidInput);
  EXPECT_THROW(evaluate(mesh, {}), InvalidInput);
  EXPECT_THROW(measure_distance(mesh, {}, 10), InvalidInput);
  EXPECT_THROW(measure_distance(mesh, flat, 10), InvalidInput);
  EXPECT_THROW(measure_distance(mesh, mesh, 0), InvalidInput);
  EXPECT_THROW(certify_distance(mesh, {}), InvalidInput);
  EXPECT_THROW(certify_distance(mesh, mesh, -1), InvalidInput);
  EXPECT_THROW(closest_points({}, {}), InvalidInput);
  EXPECT_THROW(closest_points(mesh, {{0, std::numeric_limits<double>::quiet_NaN(), 0}}),
               InvalidInput);
  EXPECT_THROW(remesh_within(mesh, 0, {}), InvalidInput);
  EXPECT_THROW(remesh_within(mesh, std::numeric_limits<double>::quiet_NaN(), {}), InvalidInput);
  EXPECT_THROW(remesh_within(mesh, 1e-12, {}), InvalidInput);
  RemeshOptions counted;
  counted.vertex_count = 10;
  EXPECT_THROW(remesh_within(mesh, 0.1, counted), InvalidInput);
}

TEST(RenderLibrary, DrawsAPictureOrNothing) {
  const TemporaryFolder folder;
  const Mesh mesh = icosphere(320);
  const Tessellation tessellation = tessellation_of(mesh, 5);
  const auto picture = folder.path() / "picture.png";
  RenderOptions options;
  options.width = options.height = 128;
  render_regions(picture, mesh, tessellation, options);
  EXPECT_EQ(read_file(picture).substr(1, 3), "PNG");
  render_mesh(folder.path() / "mesh.png", mesh, options);
  EXPECT_NE(read_file(folder.path() / "mesh.png"), read_file(picture));

  const auto refused = folder.path() / "refused.png";
  options.width = 20;
  EXPECT_THROW(render_mesh(refused, mesh, options), InvalidInput);
  options.width = 128;
  options.elevation = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(render_mesh(refused, mesh, options), InvalidInput);
  EXPECT_THROW(render_regions(refused, icosphere(80), tessellation), InvalidInput);
  EXPECT_FALSE(std::filesystem::exists(refused));
}

}  // namespace
}  // namespace geolloyd
