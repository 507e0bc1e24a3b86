#include "core/surface/features/small_features.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_measure.h"
#include "core/shapes/shapes.h"
#include "core/surface/creases/creases.h"
#include "core/surface/sizing/recipe.h"
#include "core/surface/substrate/surface_input.h"
#include "geolloyd/remesh.h"
#include "tests/support/sharp_solids.h"

namespace geolloyd {
namespace {

Remesh remesh_with_small(const Mesh& mesh, std::size_t vertices, bool small) {
  RemeshOptions options;
  options.vertex_count = vertices;
  options.features.small = small;
  return remesh(mesh, options, reference_runtime());
}

double volume_inside(const Mesh& mesh) {
  double six_fold = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    six_fold += dot(mesh.positions[a], cross(mesh.positions[b], mesh.positions[c]));
  }
  return six_fold / 6;
}

double even_spacing(const Mesh& mesh, double vertices) {
  double area = 0;
  for (const double a : triangle_areas(mesh, {})) area += a;
  return spacing_of(area, vertices);
}

SurfaceInput surface_of(const Mesh& mesh, double spacing) {
  const std::vector<TrianglePair> features = find_features(mesh, find_edges(mesh), {}, spacing);
  SurfaceInputOptions options;
  options.longest_edge = 0.42 * spacing;
  options.vertex_limit = 1'000'000;
  options.features = features;
  return make_surface_input(mesh, options);
}

// Of a rim, by its height and radius: vertices of eight chords are outside by up to a twentieth.
std::size_t vertices_on_rim(const Remesh& remesh, double radius, double height) {
  const auto is_there = [&](std::size_t v) {
    const Vec3& p = remesh.mesh.positions[v];
    return std::abs(p.z() - height) < 1e-9 &&
           std::abs(std::hypot(p.x(), p.y()) / radius - 1) < 0.06;
  };
  std::size_t count = 0;
  for (std::size_t v = 0; v < remesh.curve_vertices; ++v) count += is_there(v) ? 1 : 0;
  return count;
}

// Its rim is two to five spacings long.
TEST(SmallFeatures, OfAHoleKeepItRound) {
  constexpr double thickness = 0.3;
  for (const double radius : {0.05, 0.08, 0.12}) {
    const Mesh plate = pierced_plate(radius, thickness, 64);
    const Remesh remesh = remesh_with_small(plate, 500, true);
    EXPECT_TRUE(remesh.has_input_topology()) << radius;
    EXPECT_EQ(remesh.mesh.vertex_count(), 500U) << radius;
    for (const double height : {0.0, thickness}) {
      EXPECT_GE(vertices_on_rim(remesh, radius, height), 8U) << radius;
    }
    EXPECT_NEAR(volume_inside(remesh.mesh) / volume_inside(plate), 1, 0.003) << radius;
    EXPECT_GT(remesh.small_feature_share, 0) << radius;
    EXPECT_FALSE(remesh.small_features_limited) << radius;
    EXPECT_LT(vertices_on_rim(remesh_with_small(plate, 500, false), radius, thickness), 8U)
        << radius;
  }
}

TEST(SmallFeatures, OfAThinWallAreFoundOnBothSides) {
  const Mesh plate = pierced_plate(0.5, 0.02, 32);
  const double spacing = even_spacing(plate, 2000);
  const SurfaceInput input = surface_of(plate, spacing);
  const double unit = spacing * input.frame.scale;
  const SmallFeatures found = find_small_features(input, unit, growth_at_small_features);
  ASSERT_EQ(found.sizes.size(), input.fine.vertex_count());
  for (const auto& edge : input.feature_edges) {
    for (const VertexId v : edge) EXPECT_LT(found.sizes[v], 1) << v;
  }
}

// It gets narrow without end, and opens to a spacing.
TEST(SmallFeatures, AreNoneAtTheTipOfAWedge) {
  for (const double degrees : {20.0, 30.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    const Mesh wedge = {{{0, 0, 0}, {1, 0, 0}, {std::cos(angle), std::sin(angle), 0}}, {{0, 1, 2}}};
    const SurfaceInput input = surface_of(wedge, 0.05);
    const double unit = 0.05 * input.frame.scale;
    EXPECT_TRUE(find_small_features(input, unit, growth_at_small_features).sizes.empty())
        << degrees;
  }
}

// Sizes grow no faster than they may, are none above 1, and take no more vertices than they may.
TEST(SmallFeatures, GrowAndAreLimited) {
  for (const double vertices : {100.0, 400.0, 1000.0}) {
    const Mesh plate = pierced_plate(0.08, 0.1, 64);
    const double spacing = even_spacing(plate, vertices);
    const SurfaceInput input = surface_of(plate, spacing);
    const double unit = spacing * input.frame.scale;
    const SmallFeatures found = find_small_features(input, unit, growth_at_small_features);
    EXPECT_LE(found.share, 1.0 / 3);
    for (VertexId v = 0; v < found.sizes.size(); ++v) {
      EXPECT_LE(found.sizes[v], 1);
      EXPECT_GE(found.sizes[v], 0.125);
      for (const VertexId u : input.fine.neighbours(v)) {
        const double way = norm(input.fine.positions[u] - input.fine.positions[v]) / unit;
        EXPECT_LE(found.sizes[u] - found.sizes[v], (growth_at_small_features - 1) * way + 1e-12);
      }
    }
  }
}

TEST(SmallFeatures, AreNoneWhereNothingIsSmall) {
  for (const Mesh& mesh : {creature(3000, 1), cube(300), irregular_plane(500, 1)}) {
    const Remesh with = remesh_with_small(mesh, 200, true);
    EXPECT_EQ(with.small_feature_share, 0);
    EXPECT_EQ(with.fingerprint, remesh_with_small(mesh, 200, false).fingerprint);
  }
}

}  // namespace
}  // namespace geolloyd
