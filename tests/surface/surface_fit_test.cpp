#include "core/surface/fit/surface_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_measure.h"
#include "core/mesh/mesh_quality.h"
#include "core/shapes/shapes.h"
#include "geolloyd/remesh.h"
#include "tests/support/odd_surfaces.h"
#include "tests/support/remesh_with_fit.h"
#include "tests/support/shared_meshes.h"
#include "tests/support/surface.h"

namespace geolloyd {
namespace {

double volume_of(const Mesh& mesh) {
  double volume = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    volume += dot(mesh.positions[a], cross(mesh.positions[b], mesh.positions[c])) / 6;
  }
  return volume;
}

RegionId nearest_vertex(const Mesh& mesh, const Vec3& p) {
  const auto square_to = [&](const Vec3& q) { return dot(p - q, p - q); };
  const auto nearest =
      std::min_element(mesh.positions.begin(), mesh.positions.end(),
                       [&](const Vec3& a, const Vec3& b) { return square_to(a) < square_to(b); });
  return static_cast<RegionId>(nearest - mesh.positions.begin());
}

// Vertices on a sphere leave all of the remesh inside; a fitted remesh has some of it outside, so
// that nearly nothing is missing from its volume.
TEST(SurfaceFit, OfASphereHasItsVolume) {
  const Mesh sphere = icosphere(2000);
  const double volume = volume_of(sphere);
  for (const std::size_t vertices : {50U, 200U}) {
    const double missing = volume - volume_of(remesh_with_fit(sphere, vertices, false).mesh);
    const double left = volume - volume_of(remesh_with_fit(sphere, vertices, true).mesh);
    EXPECT_GT(missing, 0);
    EXPECT_LT(std::abs(left), 0.15 * missing) << vertices;
  }
}

// Nearly all vertices are outside. A chord of a sphere with an edge of h sinks by h^2/8.
TEST(SurfaceFit, OfASphereMovesOutward) {
  const Remesh remesh = remesh_with_fit(icosphere(2000), 300, true);
  EXPECT_GT(remesh.vertices_fitted, 280U);
  const double spacing = std::sqrt(8 * std::numbers::pi / (std::sqrt(3.0) * 300));
  double mean = 0;
  for (const Vec3& p : remesh.mesh.positions) {
    EXPECT_GT(norm(p), 0.99);
    mean += norm(p) / 300;
    EXPECT_LT(norm(p), 1 + spacing * spacing / 6);
  }
  EXPECT_GT(mean, 1);
}

TEST(SurfaceFit, LeavesFlatFacesFlat) {
  const Remesh plane = remesh_with_fit(irregular_plane(2000, 1), 300, true);
  for (const Vec3& p : plane.mesh.positions) EXPECT_NEAR(p.z(), 0, 1e-12);
  const Remesh box = remesh_with_fit(cube(192), 300, true);
  double area = 0;
  for (const double a : triangle_areas(box.mesh, {})) area += a;
  EXPECT_NEAR(area, 6, 1e-9);
}

// Angles of 30 degrees are as good as larger ones where vertices get more regular by them.
TEST(SurfaceFit, KeepsTopologyAnglesAndQuality) {
  for (const Mesh& mesh : {creature(1500, 1), scaled(icosphere(500), {1, 1, 0.05})}) {
    const Remesh free = remesh_with_fit(mesh, 200, false);
    const Remesh fitted = remesh_with_fit(mesh, 200, true);
    EXPECT_EQ(free.topology.parts, fitted.topology.parts);
    const MeshQuality before = measure_quality(free.mesh, find_edges(free.mesh));
    const MeshQuality after = measure_quality(fitted.mesh, find_edges(fitted.mesh));
    EXPECT_GE(after.smallest_angle, std::min(before.smallest_angle, 30.0) - 2 - 1e-9);
    EXPECT_GE(after.mean_quality, before.mean_quality - 0.035);
    EXPECT_LE(count_folds(fitted.mesh, find_edges(fitted.mesh)),
              count_folds(free.mesh, find_edges(free.mesh)));
  }
}

// Where sites are as far apart as a tube is thick, some places can't come closer: all others do.
TEST(SurfaceFit, OfOneBadPlaceIsAFitElsewhere) {
  const Mesh mesh = thin_torus(0.05, 24);
  for (const std::size_t vertices : {400U, 600U}) {
    const Remesh fitted = remesh_with_fit(mesh, vertices, true);
    EXPECT_LT(fitted.distance_after_fit, 0.8 * fitted.distance_before_fit) << vertices;
    EXPECT_GT(volume_of(fitted.mesh), 0.9 * volume_of(mesh)) << vertices;
  }
}

// Feet are followed from triangle to triangle, and thin walls lead them astray: nevertheless no
// point of the surface ends farther from the remesh than the farthest one was.
TEST(SurfaceFit, LeavesNoPointFarther) {
  for (const Mesh& mesh : {thin_torus(0.05, 24), flat_box(0.02), creature(3000, 1)}) {
    for (const std::size_t vertices : {100U, 300U}) {
      Mesh moving = remesh_with_fit(mesh, vertices, false).mesh;
      const SurfaceInput input = surface_input_of(mesh, 0.1);
      std::vector<RegionId> labels;
      for (const Vec3& p : input.fine.positions) {
        labels.push_back(nearest_vertex(moving, input.frame.to_mesh(p)));
      }
      const FitResult result = fit_to_surface(input, labels, 0, {}, moving);
      EXPECT_LE(result.after.largest, std::max(result.before.largest, result.negligible));
      EXPECT_EQ(result.far_at.size(), moving.vertex_count());
      EXPECT_EQ(*std::max_element(result.far_at.begin(), result.far_at.end()),
                result.after.largest);
    }
  }
}

TEST(SurfaceFit, StopsWhenItIsTold) {
  const Mesh mesh = creature(3000, 1);
  const SurfaceInput input = surface_input_of(mesh, 0.1);
  const Mesh start = remesh_with_fit(mesh, 100, false).mesh;
  std::vector<RegionId> labels;
  for (const Vec3& p : input.fine.positions) {
    labels.push_back(nearest_vertex(start, input.frame.to_mesh(p)));
  }
  std::size_t all = 0;
  Mesh moving = start;
  fit_to_surface(input, labels, 0, {}, moving, sequential(),
                 {.keep_going = [&] { return ++all > 0; }});
  EXPECT_GT(all, 30U);
  for (std::size_t stop = 1; stop < all; stop += all / 8) {
    std::size_t asked = 0;
    Mesh stopped = start;
    const FitResult result = fit_to_surface(input, labels, 0, {}, stopped, sequential(),
                                            {.keep_going = [&] { return ++asked < stop; }});
    EXPECT_LE(asked, stop + 3) << stop;
    EXPECT_LE(result.after.mean_square, result.before.mean_square) << stop;
    EXPECT_EQ(stopped.triangles, start.triangles);
  }
}

// Of meshes of others that were hardly fitted, as one sample of many was far.
TEST(SurfaceFit, KeepsTheVolumeOfHardMeshes) {
  constexpr double most = 0.02;
  const Mesh fertility = hard_mesh("fertility.off");
  const Mesh knot = hard_mesh("quadknot.obj");
  if (fertility.triangles.empty() || knot.triangles.empty()) GTEST_SKIP() << "no shared meshes";
  const auto expect = [&](const Mesh& mesh, std::size_t vertices) {
    const double volume = volume_of(mesh);
    EXPECT_NEAR(volume_of(remesh_with_fit(mesh, vertices, true).mesh), volume,
                most * std::abs(volume))
        << vertices;
  };
  for (const std::size_t vertices : {300U, 500U, 700U}) expect(fertility, vertices);
  expect(knot, 300);
}

TEST(SurfaceFit, OfNothing) {
  Mesh none;
  SurfaceInput input;
  EXPECT_EQ(fit_to_surface(input, {}, 0, {}, none).moved, 0U);
}

}  // namespace
}  // namespace geolloyd
