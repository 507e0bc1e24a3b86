#include "core/surface/result/site_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/closest_on_triangle.h"
#include "core/shapes/shapes.h"
#include "core/surface/cells/reference_surface_engine.h"
#include "tests/support/random_graph.h"
#include "tests/support/surface.h"

namespace geolloyd {
namespace {

double distance_to_mesh(const Mesh& mesh, const Vec3& p) {
  double least = 1e300;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]] - p;
    const Vec3 b = mesh.positions[t[1]] - p;
    const Vec3 c = mesh.positions[t[2]] - p;
    const auto [v, w] = barycentric_closest_to_origin({a, b, c});
    least = std::min(least, norm(a + v * (b - a) + w * (c - a)));
  }
  return least;
}

void expect_on_mesh(const Mesh& mesh, const SurfacePoint& point) {
  ASSERT_LT(point.triangle, mesh.triangle_count());
  EXPECT_GE(std::ranges::min(point.barycentric), 0);
  EXPECT_NEAR(point.barycentric[0] + point.barycentric[1] + point.barycentric[2], 1, 1e-14);
}

// Sites near their cells: as near as the surface is to them, on one of its triangles.
void expect_closest(const Mesh& mesh, std::size_t count, double longest_edge, double stray) {
  const SurfaceInput input = surface_input_of(mesh, longest_edge);
  SitedMesh sited = spread_sites(input.fine, count);
  for (std::size_t r = 0; r < count; ++r) sited.sites[r] += random_point(7, r, stray);
  const auto engine = make_reference_surface_engine(input.fine);
  engine->assign(sited.labels, sited.is_fixed);
  engine->evaluate(sited.sites);
  const std::vector<SurfacePoint> places = place_sites(mesh, input, sited.sites, engine->labels());
  ASSERT_EQ(places.size(), count);
  for (std::size_t r = 0; r < count; ++r) {
    expect_on_mesh(mesh, places[r]);
    const Vec3 site = input.frame.to_mesh(sited.sites[r]);
    EXPECT_NEAR(norm(position_of(mesh, places[r]) - site), distance_to_mesh(mesh, site), 1e-12)
        << r;
  }
}

TEST(SitePlaces, AreTheClosestPoints) {
  for (const Mesh& mesh : {irregular_plane(800, 1), icosphere(800), torus(1000, 1)}) {
    expect_closest(mesh, 30, 0, 0.0);
    expect_closest(mesh, 30, 0, 0.01);
    expect_closest(mesh, 30, 0, 0.04);
  }
}

// Places are on the mesh's triangles, not on the pieces of the fine mesh.
TEST(SitePlaces, AreOnTheTrianglesOfACoarseMesh) {
  for (const Mesh& mesh : {icosphere(20), torus(40, 1), irregular_plane(8, 1)}) {
    expect_closest(mesh, 40, 0.1, 0.01);
  }
}

// The nearest vertex's cell decides, not the nearest surface.
TEST(SitePlaces, StayOnTheirSheet) {
  const double gap = 0.01;
  Mesh sheets = irregular_plane(400, 1);
  add_mesh(sheets, irregular_plane(400, 1), {0, 0, gap});
  const SurfaceInput input = surface_input_of(sheets);
  const SitedMesh sited = spread_sites(input.fine, 40);
  const auto engine = make_reference_surface_engine(input.fine);
  engine->assign(sited.labels, sited.is_fixed);
  engine->evaluate(sited.sites);
  std::vector<Vec3> sites = sited.sites;
  for (Vec3& site : sites) site.z() = -site.z();  // nearer to the other sheet
  const auto places = place_sites(sheets, input, sites, engine->labels());
  for (std::size_t r = 0; r < sites.size(); ++r) {
    const double z = position_of(sheets, places[r]).z();
    EXPECT_EQ(z > gap / 2, sited.sites[r].z() > 0) << r;
  }
}

TEST(SitePlaces, OfASiteWithoutACellIsNone) {
  const Mesh mesh = icosphere(100);
  const SurfaceInput input = surface_input_of(mesh);
  std::vector<RegionId> labels(input.fine.vertex_count(), 1);
  labels[5] = no_id;
  const auto places =
      place_sites(mesh, input, {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, 1, 0)}, labels);
  EXPECT_EQ(places[0].triangle, no_id);
  EXPECT_EQ(places[2].triangle, no_id);
  expect_on_mesh(mesh, places[1]);
}

TEST(SitePlaces, OfFlatTrianglesAreValid) {
  Mesh mesh = irregular_plane(200, 1);
  for (Vec3& p : mesh.positions) p.y() = std::round(2 * p.y()) / 2;  // most have no area
  const SurfaceInput input = surface_input_of(mesh);
  const SitedMesh sited = spread_sites(input.fine, 20);
  const auto engine = make_reference_surface_engine(input.fine);
  engine->assign(sited.labels, sited.is_fixed);
  engine->evaluate(sited.sites);
  std::vector<Vec3> sites = sited.sites;
  for (std::size_t r = 0; r < sites.size(); ++r) sites[r] += random_point(1, r, 0.1);
  const auto places = place_sites(mesh, input, sites, engine->labels());
  for (std::size_t r = 0; r < sites.size(); ++r) {
    if (places[r].triangle != no_id) expect_on_mesh(mesh, places[r]);
  }
}

// Of equals, the triangle with the smaller id.
TEST(SitePlaces, AtVerticesAreThere) {
  const Mesh mesh = torus(300, 1);
  const SurfaceInput input = surface_input_of(mesh);
  std::vector<RegionId> labels;
  for (VertexId v = 0; v < input.fine.vertex_count(); ++v) labels.push_back(v);
  const auto places = place_sites(mesh, input, input.fine.positions, labels);
  for (VertexId v = 0; v < places.size(); ++v) {
    const auto around = input.fine.triangles_at(v);
    EXPECT_EQ(places[v].triangle, input.origin[around[0]]);
    EXPECT_LE(norm(input.frame.to_unit(position_of(mesh, places[v])) - input.fine.positions[v]),
              1e-15);
  }
}

}  // namespace
}  // namespace geolloyd
