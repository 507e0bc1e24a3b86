#include "core/surface/features/feature_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/shapes/shapes.h"
#include "core/surface/features/curve_sites.h"
#include "geolloyd/remesh.h"
#include "tests/support/random_graph.h"
#include "tests/support/surface.h"

namespace geolloyd {
namespace {

// A regular polygon of radius 1, cut into triangles about its middle.
Mesh regular_polygon(VertexId corners) {
  Mesh mesh;
  mesh.positions.emplace_back(0, 0, 0);
  for (VertexId i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    mesh.triangles.push_back({0, i + 1, (i + 1) % corners + 1});
  }
  return mesh;
}

// One triangle in fifty is missing, and what is about five places.
Mesh riddled_plane(std::uint64_t random_seed) {
  Mesh plane = irregular_plane(1200, random_seed);
  std::vector<Vec3> holes;
  for (std::uint64_t h = 0; h < 5; ++h) {
    holes.emplace_back(random_point(random_seed, h, 0.5) + Vec3::Constant(0.5));
  }
  std::uint64_t n = 1000;
  std::erase_if(plane.triangles, [&](const Triangle& t) {
    const Vec3& p = plane.positions[t[0]];
    const bool is_in_hole = std::ranges::any_of(holes, [&](const Vec3& hole) {
      return std::hypot(p.x() - hole.x(), p.y() - hole.y()) < 0.3 * hole.z();
    });
    return is_in_hole || random_number(random_seed, n++, 50) == 0;
  });
  return plane;
}

Vec3 point_at(const SurfaceInput& input, const FeatureCurve& curve, double arc) {
  std::size_t i = 1;
  while (i + 1 < curve.arc.size() && curve.arc[i] < arc) ++i;
  const Vec3& a = input.fine.positions[curve.vertices[i - 1]];
  const Vec3& b = input.fine.positions[curve.vertices[i]];
  const double edge = curve.arc[i] - curve.arc[i - 1];
  return edge > 0 ? Vec3(a + (b - a) * ((arc - curve.arc[i - 1]) / edge)) : a;
}

void expect_curve(const SurfaceInput& input, const FeatureCurve& curve) {
  ASSERT_GE(curve.vertices.size(), 2U);
  ASSERT_EQ(curve.arc.size(), curve.vertices.size());
  EXPECT_EQ(curve.arc[0], 0);
  for (std::size_t i = 1; i < curve.vertices.size(); ++i) {
    const VertexId a = curve.vertices[i - 1];
    const VertexId b = curve.vertices[i];
    EXPECT_TRUE(std::ranges::binary_search(input.boundary_edges, ascending(a, b)));
    EXPECT_NEAR(curve.arc[i] - curve.arc[i - 1],
                norm(input.fine.positions[a] - input.fine.positions[b]), 1e-12);
  }
  EXPECT_TRUE(!curve.is_loop || curve.vertices.front() == curve.vertices.back());
}

// Every edge of the boundary is in one curve or one sub-resolution hole.
void expect_whole_boundary(const SurfaceInput& input, const FeatureCurves& curves) {
  std::vector<std::array<VertexId, 2>> edges;
  std::set<VertexId> ends;
  std::set<VertexId> vertices;
  for (const FeatureCurve& curve : curves.curves) {
    expect_curve(input, curve);
    vertices.insert(curve.vertices.begin(), curve.vertices.end());
    for (std::size_t i = 1; i < curve.vertices.size(); ++i) {
      edges.push_back(ascending(curve.vertices[i - 1], curve.vertices[i]));
    }
    if (!curve.is_loop) ends.insert({curve.vertices.front(), curve.vertices.back()});
  }
  for (const std::vector<VertexId>& loop : curves.subresolution_holes) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      edges.push_back(ascending(loop[i], loop[(i + 1) % loop.size()]));
    }
  }
  std::sort(edges.begin(), edges.end());
  EXPECT_EQ(edges, input.boundary_edges);
  EXPECT_TRUE(std::ranges::equal(curves.corners, ends));
  EXPECT_TRUE(std::ranges::equal(curves.vertices, vertices));
}

RegionId label_of(const FeatureCurves& curves, const CurveSites& placed, VertexId v) {
  const auto found = std::ranges::lower_bound(curves.vertices, v);
  EXPECT_TRUE(found != curves.vertices.end() && *found == v);
  return placed.label[static_cast<std::size_t>(found - curves.vertices.begin())];
}

// From end to end a curve's vertices have its sites in their order, each at least once. Sites are
// as far from each other along it, but beside acute corners, and each vertex has the nearest.
void expect_even_sites(const SurfaceInput& input, const FeatureCurves& curves,
                       const FeatureCurve& curve, const CurveSites& placed, double spacing) {
  const std::size_t intervals = curve.intervals(spacing);
  EXPECT_EQ(intervals, std::max(curve.least_intervals,
                                static_cast<std::size_t>(curve.of_chords / spacing + 0.5)));
  const double step = intervals < 2 ? curve.length()
                                    : curve.length() / (static_cast<double>(intervals) - 2 +
                                                        curve.first_step + curve.last_step);
  std::size_t place = 0;
  RegionId last = label_of(curves, placed, curve.vertices[0]);
  for (std::size_t i = 0; i < curve.vertices.size(); ++i) {
    const RegionId label = label_of(curves, placed, curve.vertices[i]);
    if (label != last) ++place;
    last = label;
    const double at = place == 0 ? 0
                      : place == intervals
                          ? curve.length()
                          : step * (static_cast<double>(place - 1) + curve.first_step);
    EXPECT_LE(norm(placed.sites[label] - point_at(input, curve, at)), 1e-12);
    const double longest = std::max({1.0, curve.first_step, curve.last_step});
    EXPECT_LE(std::abs(curve.arc[i] - at), longest * step / 2 + 1e-12);
  }
  EXPECT_EQ(place, intervals) << "a site without a vertex";
}

void expect_sites(const SurfaceInput& input, const FeatureCurves& curves, double spacing) {
  const CurveSites placed = place_curve_sites(input, curves, spacing);
  std::size_t count = curves.corners.size();
  for (const FeatureCurve& curve : curves.curves) {
    expect_even_sites(input, curves, curve, placed, spacing);
    count += curve.intervals(spacing) - (curve.is_loop ? 0 : 1);
  }
  EXPECT_EQ(placed.sites.size(), count);
  ASSERT_EQ(placed.label.size(), curves.vertices.size());
  for (std::size_t i = 0; i < curves.vertices.size(); ++i) {
  }
  for (std::size_t c = 0; c < curves.corners.size(); ++c) {
    EXPECT_EQ(placed.sites[c], input.fine.positions[curves.corners[c]]);
  }
}

void expect_a_vertex_each(const CurveSites& placed) {
  const std::set<RegionId> met(placed.label.begin(), placed.label.end());
  EXPECT_EQ(met.size(), placed.sites.size());
  EXPECT_TRUE(met.empty() || *met.rbegin() < placed.sites.size());
  EXPECT_GE(met.size(), 6U) << "three on each loop";
}

// The longest edge that a surface input has for this spacing (surface_remesh.h), mesh units.
SurfaceInput input_for(const Mesh& mesh, double spacing_in_mesh) {
  return surface_input_of(mesh, 0.558 * spacing_in_mesh);
}

TEST(FeatureCurves, OfASquareAreItsSides) {
  const Mesh square = irregular_plane(1800, 1);
  for (const double spacing : {0.3, 0.21, 0.1, 0.037}) {
    const SurfaceInput input = input_for(square, spacing);
    const double scaled = spacing * input.frame.scale;
    const FeatureCurves curves = find_feature_curves(input, scaled, true);
    EXPECT_EQ(curves.corners.size(), 4U);
    ASSERT_EQ(curves.curves.size(), 4U);
    EXPECT_TRUE(curves.subresolution_holes.empty());
    for (const FeatureCurve& curve : curves.curves) {
      EXPECT_FALSE(curve.is_loop);
      EXPECT_NEAR(curve.length(), input.frame.scale, 1e-12);
      EXPECT_EQ(curve.intervals(scaled), static_cast<std::size_t>(std::lround(1 / spacing)));
    }
    expect_whole_boundary(input, curves);
    expect_sites(input, curves, scaled);
    // Levels put fewer on the same curves.
    expect_sites(input, curves, 2 * scaled);
    expect_sites(input, curves, 4 * scaled);
  }
}

TEST(FeatureCurves, OfADiscIsALoop) {
  const SurfaceInput input = input_for(regular_polygon(60), 0.2);
  const double spacing = 0.2 * input.frame.scale;
  const FeatureCurves curves = find_feature_curves(input, spacing, true);
  EXPECT_TRUE(curves.corners.empty());
  ASSERT_EQ(curves.curves.size(), 1U);
  EXPECT_TRUE(curves.curves[0].is_loop);
  EXPECT_EQ(curves.curves[0].vertices.front(), 0U) << "begins at its smallest vertex";
  EXPECT_NEAR(curves.curves[0].length(), 120 * std::sin(std::numbers::pi / 60) * input.frame.scale,
              1e-12);
  expect_whole_boundary(input, curves);
  for (const double factor : {1.0, 2.0, 4.0, 100.0}) expect_sites(input, curves, factor * spacing);
  EXPECT_EQ(place_curve_sites(input, curves, 100 * spacing).sites.size(), 3U);
}

// An octagon turns by 45 degrees at a corner, a polygon of 13 by 28.
TEST(FeatureCurves, TurnSharplyAtCorners) {
  for (const VertexId corners : {3U, 4U, 7U, 8U, 11U, 13U}) {
    const SurfaceInput input = input_for(regular_polygon(corners), 0.1);
    const FeatureCurves curves = find_feature_curves(input, 0.1 * input.frame.scale, true);
    EXPECT_EQ(curves.corners.size(), corners < 12 ? corners : 0) << corners;
    EXPECT_EQ(curves.curves.size(), corners < 12 ? corners : 1) << corners;
    expect_whole_boundary(input, curves);
    expect_sites(input, curves, 0.1 * input.frame.scale);
  }
}

// Chords between its sites are as long as edges elsewhere, though the way along it is longer.
TEST(FeatureCurves, OfAJaggedBoundaryHaveChordsOfOneSpacing) {
  constexpr VertexId teeth = 400;
  Mesh disc = regular_polygon(2 * teeth);
  for (VertexId v = 1; v < disc.vertex_count(); v += 2) disc.positions[v] *= 0.98;
  const SurfaceInput input = input_for(disc, 0.2);
  const double spacing = 0.2 * input.frame.scale;
  const FeatureCurves curves = find_feature_curves(input, spacing, true);
  ASSERT_EQ(curves.curves.size(), 1U);
  EXPECT_GT(curves.curves[0].length(), 2.5 * 2 * std::numbers::pi * input.frame.scale);
  const CurveSites placed = place_curve_sites(input, curves, spacing);
  double chords = 0;
  for (std::size_t i = 0; i < placed.sites.size(); ++i) {
    chords += norm(placed.sites[i] - placed.sites[(i + 1) % placed.sites.size()]);
  }
  const double count = static_cast<double>(placed.sites.size());
  EXPECT_NEAR(chords / count / spacing, 1, 0.05);
  EXPECT_NEAR(count, 2 * std::numbers::pi / 0.2, 2);
}

// Rounded within half a spacing, a corner is one still.
TEST(FeatureCurves, TurnAtRoundedCorners) {
  Mesh disc = regular_polygon(80);  // a quarter of a circle of radius 0.02 at each corner
  for (std::size_t v = 1; v <= 80; ++v) {
    Vec3& p = disc.positions[v];
    p = 0.02 * p + Vec3(p.x() + p.y() > 0 ? 1 : -1, p.y() - p.x() > 0 ? 1 : -1, 0);
  }
  const SurfaceInput input = input_for(disc, 0.2);
  const FeatureCurves curves = find_feature_curves(input, 0.2 * input.frame.scale, true);
  EXPECT_EQ(curves.corners.size(), 4U);
  expect_whole_boundary(input, curves);
  expect_sites(input, curves, 0.2 * input.frame.scale);
}

TEST(FeatureCurves, OfAClosedSurfaceAreNone) {
  const SurfaceInput input = surface_input_of(icosphere(100));
  const FeatureCurves curves = find_feature_curves(input, 0.1, true);
  EXPECT_TRUE(curves.curves.empty());
  EXPECT_TRUE(curves.subresolution_holes.empty());
  EXPECT_TRUE(place_curve_sites(input, curves, 0.1).sites.empty());
}

TEST(FeatureCurves, OfATubeAreTwoLoops) {
  const SurfaceInput input = input_for(cylinder(2000, 1), 0.2);
  const double spacing = 0.2 * input.frame.scale;
  const FeatureCurves curves = find_feature_curves(input, spacing, true);
  ASSERT_EQ(curves.curves.size(), 2U);
  EXPECT_TRUE(curves.corners.empty());
  expect_whole_boundary(input, curves);
  for (const double factor : {1.0, 2.0, 4.0}) expect_sites(input, curves, factor * spacing);
}

// A sphere with a triangle missing.
SurfaceInput punctured_sphere() {
  Mesh sphere = icosphere(500);
  sphere.triangles.erase(sphere.triangles.begin() + 100);
  return surface_input_of(sphere);
}

double length_of_boundary(const SurfaceInput& input) {
  double length = 0;
  for (const auto& [a, b] : input.boundary_edges) {
    length += norm(input.fine.positions[a] - input.fine.positions[b]);
  }
  return length;
}

// Three sites on it would be less than 0.6 spacings apart.
TEST(FeatureCurves, OfATinyHoleIsAPinhole) {
  const SurfaceInput input = punctured_sphere();
  const double length = length_of_boundary(input);
  const FeatureCurves tiny = find_feature_curves(input, length / 1.79, true);
  ASSERT_EQ(tiny.subresolution_holes.size(), 1U);
  EXPECT_EQ(tiny.subresolution_holes[0].size(), 3U);
  EXPECT_TRUE(tiny.curves.empty());
  EXPECT_TRUE(tiny.vertices.empty());
  EXPECT_EQ(tiny.loops.size(), 1U);
  EXPECT_TRUE(place_curve_sites(input, tiny, length / 1.79).sites.empty());
  const FeatureCurves large = find_feature_curves(input, length / 2.6, true);
  EXPECT_TRUE(large.subresolution_holes.empty());
  EXPECT_EQ(large.loops.size(), 1U);
  EXPECT_EQ(place_curve_sites(input, large, length / 2.6).sites.size(), 3U);
}

TEST(FeatureCurves, HavePinholesOnlyWhereTheyMay) {
  const SurfaceInput input = punctured_sphere();
  for (const double spacing : {0.05, 0.2, 0.5, 2.0}) {
    const FeatureCurves curves = find_feature_curves(input, spacing, false);
    EXPECT_TRUE(curves.subresolution_holes.empty());
    expect_whole_boundary(input, curves);
  }
  const double barely = std::sqrt(input.fine.whole_area / 8);
  EXPECT_EQ(find_feature_curves(input, 0.99 * barely, true).subresolution_holes.size(), 1U);
  EXPECT_TRUE(find_feature_curves(input, 1.01 * barely, true).subresolution_holes.empty());
}

// At least three vertices in every loop, and each has a vertex of the surface.
TEST(FeatureCurves, OfHolesOfAnyShape) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const double spacing = 0.02 * std::pow(1.3, static_cast<double>(seed % 10));
    const SurfaceInput input = input_for(riddled_plane(seed), spacing);
    const double scaled = spacing * input.frame.scale;
    const FeatureCurves curves = find_feature_curves(input, scaled, true);
    expect_whole_boundary(input, curves);
    expect_sites(input, curves, scaled);
    expect_sites(input, curves, 2 * scaled);
  }
}

// A disc of radius 0.3 with a hole about its middle.
Mesh disc_with_hole(const std::vector<Vec3>& hole) {
  const auto count = static_cast<VertexId>(hole.size());
  Mesh mesh{hole, {}};
  for (VertexId i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    mesh.positions.emplace_back(0.3 * std::cos(angle), 0.3 * std::sin(angle), 0);
    const VertexId next = (i + 1) % count;
    mesh.triangles.push_back({i, i + count, next + count});
    mesh.triangles.push_back({i, next + count, next});
  }
  return mesh;
}

double length_of(const std::vector<Vec3>& loop) {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    length += norm(loop[(i + 1) % loop.size()] - loop[i]);
  }
  return length;
}

// Lenses have two corners, drops have one, with edges as long as they may be. Even where three
// sites are close together, each has a vertex.
TEST(FeatureCurves, OfSmallHolesOfAnyShape) {
  for (const double width : {0.01, 0.03, 0.1}) {
    for (const int corners : {0, 1, 2}) {
      for (const std::uint64_t points : {3U, 5U, 6U, 8U, 30U}) {
        std::vector<Vec3> hole;
        for (std::uint64_t i = 0; i < points; ++i) {
          const double offset = 0.9 * random_unit(points, i);
          const double angle = 2 * std::numbers::pi * (static_cast<double>(i) + offset) /
                               static_cast<double>(points);
          const double x = std::cos(angle);
          const double taper = corners == 0 ? 1 : corners == 1 ? (1 - x) / 2 : 1 - x * x;
          hole.emplace_back(0.1 * x, width * std::sqrt(taper) * std::sin(angle), 0);
        }
        for (double spacings = 0.5; spacings < 5; spacings += 0.15) {
          SCOPED_TRACE(testing::Message() << corners << " corners, width " << width << ", "
                                          << points << " points, " << spacings << " spacings");
          const double spacing = length_of(hole) / spacings;
          const SurfaceInput input = input_for(disc_with_hole(hole), spacing);
          const double scaled = spacing * input.frame.scale;
          const FeatureCurves curves = find_feature_curves(input, scaled, false);
          expect_whole_boundary(input, curves);
          if (spacings > 1.8) expect_sites(input, curves, scaled);
          expect_a_vertex_each(place_curve_sites(input, curves, scaled));
          expect_a_vertex_each(place_curve_sites(input, curves, 2 * scaled));
        }
      }
    }
  }
}

// Where edges are longer than the spacing, there are no more intervals than edges.
TEST(FeatureCurves, OfLongEdges) {
  Mesh triangle = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  for (const Mesh& mesh :
       {triangle, irregular_plane(2, 1), irregular_plane(50, 1), cylinder(60, 1)}) {
    const SurfaceInput input = surface_input_of(mesh);
    for (const double spacing : {1.0, 0.3, 0.1, 0.01}) {
      SCOPED_TRACE(spacing);
      const FeatureCurves curves = find_feature_curves(input, spacing, false);
      expect_whole_boundary(input, curves);
      const CurveSites placed = place_curve_sites(input, curves, spacing);
      EXPECT_LE(placed.sites.size(), curves.vertices.size());
      const std::set<RegionId> met(placed.label.begin(), placed.label.end());
      EXPECT_EQ(met.size(), placed.sites.size());
      for (const FeatureCurve& curve : curves.curves) {
        EXPECT_LT(curve.intervals(spacing), curve.vertices.size());
      }
    }
  }
}

// Where the boundary has edges without length.
// Its boundary is 10^10 spacings long, or more than numbers can count. Intervals are no more than
// edges.
TEST(FeatureCurves, OfATriangleWithHardlyAnyArea) {
  const SurfaceInput input =
      surface_input_of({{{0, 0, 0}, {1, 0, 0}, {0.5, 1e-20, 0}}, {{0, 1, 2}}}, 0.1);
  for (const double spacing : {1e-10, 1e-20, 1e-40}) {
    const FeatureCurves curves = find_feature_curves(input, spacing, true);
    ASSERT_FALSE(curves.curves.empty());
    for (const FeatureCurve& curve : curves.curves) {
      EXPECT_EQ(curve.intervals(spacing), curve.vertices.size() - 1) << spacing;
    }
  }
}

// A triangle of three vertices at one place, beside an ordinary mesh.
TEST(FeatureCurves, OfATriangleThatIsAPoint) {
  for (const double size : {0.0, 1e-12}) {
    Mesh mesh = icosphere(300);
    const auto first = static_cast<VertexId>(mesh.vertex_count());
    for (const double x : {0.0, 1.0, 2.0})
      mesh.positions.emplace_back(2 + x * size, x * x * size, 0);
    mesh.triangles.push_back({first, first + 1, first + 2});
    RemeshOptions options;
    options.vertex_count = 50;
    EXPECT_TRUE(remesh(mesh, options, reference_runtime()).has_input_topology()) << size;
  }
}

TEST(FeatureCurves, OfRepeatedPlaces) {
  Mesh square = irregular_plane(200, 1);
  for (std::size_t i = 1; i < 4; ++i) square.positions[i] = square.positions[0];
  const SurfaceInput input = input_for(square, 0.2);
  const FeatureCurves curves = find_feature_curves(input, 0.2 * input.frame.scale, true);
  expect_whole_boundary(input, curves);
  EXPECT_GE(curves.corners.size(), 3U);
  const CurveSites placed = place_curve_sites(input, curves, 0.2 * input.frame.scale);
  for (const Vec3& site : placed.sites) EXPECT_LE(norm(site), 2);
}

}  // namespace
}  // namespace geolloyd
