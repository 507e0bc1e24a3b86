#include "core/surface/fit/curve_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <vector>

#include "core/mesh/segment.h"
#include "core/shapes/shapes.h"
#include "core/surface/result/site_places.h"
#include "geolloyd/remesh.h"
#include "tests/support/odd_surfaces.h"
#include "tests/support/remesh_with_fit.h"
#include "tests/support/sharp_solids.h"

namespace geolloyd {
namespace {

using Segments = std::vector<std::array<Vec3, 2>>;

Segments feature_segments(const Remesh& remesh) {
  Segments segments;
  for (const auto& [a, b] : remesh.feature_edges) {
    segments.push_back({remesh.mesh.positions[a], remesh.mesh.positions[b]});
  }
  return segments;
}

double distance_to(const Segments& segments, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : segments)
    least = std::min(least, norm(p - closest_on_segment(p, a, b)));
  return least;
}

// The two circles of a prism of many sides.
std::vector<Vec3> points_of_rims() {
  constexpr int points = 2000;
  std::vector<Vec3> found;
  for (int i = 0; i < points; ++i) {
    for (const double z : {-1.0, 1.0}) found.push_back(on_ring(i / double{points}, 1, z));
  }
  return found;
}

struct Distances {
  double mean = 0;
  double largest = 0;
};

Distances distances_of_rims(const Remesh& remesh) {
  const std::vector<Vec3> points = points_of_rims();
  const Segments segments = feature_segments(remesh);
  Distances distances;
  for (const Vec3& p : points) {
    const double distance = distance_to(segments, p);
    distances.mean += distance / static_cast<double>(points.size());
    distances.largest = std::max(distances.largest, distance);
  }
  return distances;
}

// Of a chord's sag, two thirds are its mean distance, and a quarter is that of one that crosses the
// circle twice.
TEST(CurveFit, BringsEdgesCloserToCircles) {
  const Mesh prism = sharp_prism(200);
  for (const std::size_t vertices : {60U, 300U}) {
    const Distances before = distances_of_rims(remesh_with_fit(prism, vertices, false));
    const Distances after = distances_of_rims(remesh_with_fit(prism, vertices, true));
    EXPECT_GT(before.mean, 0);
    EXPECT_LT(after.mean, 0.45 * before.mean) << vertices;
    EXPECT_LT(after.largest, 0.75 * before.largest) << vertices;
  }
}

// Of eight chords or so, too.
TEST(CurveFit, KeepsTheAreaOfSmallLoops) {
  for (const std::size_t vertices : {40U, 60U, 200U}) {
    const Remesh fitted = remesh_with_fit(sharp_prism(200), vertices, true);
    double area = 0;
    for (const auto& [a, b] : feature_segments(fitted)) {
      area += norm(cross({a.x(), a.y(), 0}, {b.x(), b.y(), 0})) / 4;  // there are two rims
    }
    EXPECT_NEAR(area, std::numbers::pi, 0.01 * std::numbers::pi) << vertices;
  }
}

// The circle stays in the planes of the caps.
TEST(CurveFit, LeavesPlanesFlat) {
  const Remesh fitted = remesh_with_fit(sharp_prism(200), 300, true);
  for (const auto& [a, b] : fitted.feature_edges) {
    EXPECT_NEAR(std::abs(fitted.mesh.positions[a].z()), 1, 1e-12);
  }
}

TEST(CurveFit, MovesNothingOnStraightCurves) {
  for (const Mesh& mesh : {cube(192), sharp_wedge(60), flat_box(0.1)}) {
    const Remesh free = remesh_with_fit(mesh, 200, false);
    const Remesh fitted = remesh_with_fit(mesh, 200, true);
    EXPECT_GT(fitted.curve_vertices, 0U);
    for (std::size_t v = 0; v < free.curve_vertices; ++v) {
      EXPECT_EQ(free.mesh.positions[v], fitted.mesh.positions[v]);
    }
  }
}

// A plate whose upper side is a graph over [0, 1].
template <class Height>
Mesh plate_under(Height&& height) {
  return grid_surface(200, 40, false, false, false,
                      [&](double along, double up) { return Vec3(along, up * height(along), 0); });
}

double distance_of_graph(const Mesh& remesh, double (*height)(double)) {
  std::map<std::array<VertexId, 2>, int> uses;
  for (const Triangle& t : remesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++uses[ascending(t[k], t[(k + 1) % 3])];
  }
  Segments boundary;
  for (const auto& [edge, count] : uses) {
    if (count == 1) boundary.push_back({remesh.positions[edge[0]], remesh.positions[edge[1]]});
  }
  double largest = 0;
  for (int i = 0; i <= 1000; ++i) {
    largest = std::max(largest, distance_to(boundary, {i / 1000.0, height(i / 1000.0), 0}));
  }
  return largest;
}

// A bend of 20 degrees is no corner: a vertex slides to it.
TEST(CurveFit, PutsAVertexWhereACurveBends) {
  constexpr auto height = [](double x) { return 0.6 + 0.36 * std::min(x, 0.475); };
  const Mesh plate = plate_under(height);
  const double before = distance_of_graph(remesh_with_fit(plate, 100, false).mesh, height);
  const double after = distance_of_graph(remesh_with_fit(plate, 100, true).mesh, height);
  EXPECT_GT(before, 1e-3);
  EXPECT_LT(after, 0.2 * before);
}

TEST(CurveFit, LeavesNoPointOfACurveFarther) {
  constexpr auto wave = [](double x) { return 0.8 + 0.06 * std::sin(40 * x); };
  constexpr auto jag = [](double x) { return 0.8 + 0.05 * std::abs(20 * x - std::round(20 * x)); };
  for (const auto height : {+wave, +jag}) {
    const Mesh plate = plate_under(height);
    for (const std::size_t vertices : {40U, 100U, 400U}) {
      const double before = distance_of_graph(remesh_with_fit(plate, vertices, false).mesh, height);
      const double after = distance_of_graph(remesh_with_fit(plate, vertices, true).mesh, height);
      EXPECT_LT(after, 1.02 * before) << vertices;
    }
  }
}

TEST(CurveFit, HoldsCorners) {
  constexpr auto height = [](double x) { return 0.8 - 0.3 * x * x; };
  const Remesh fitted = remesh_with_fit(plate_under(height), 100, true);
  for (const Vec3& corner :
       {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, height(0), 0), Vec3(1, height(1), 0)}) {
    EXPECT_EQ(std::count(fitted.mesh.positions.begin(), fitted.mesh.positions.end(), corner), 1);
  }
}

// They stand for points of the curve, though they are beside it.
TEST(CurveFit, PlacesAreOnCurves) {
  const Mesh prism = sharp_prism(50);
  const Remesh fitted = remesh_with_fit(prism, 100, true);
  double farthest = 0;
  for (const auto& edge : fitted.feature_edges) {
    for (const VertexId v : edge) {
      const Vec3 place = position_of(prism, fitted.places[v]);
      EXPECT_NEAR(std::abs(place.z()), 1, 1e-12);
      EXPECT_LE(norm({place.x(), place.y(), 0}), 1 + 1e-12);
      EXPECT_GE(norm({place.x(), place.y(), 0}), std::cos(std::numbers::pi / 50) - 1e-12);
      farthest = std::max(farthest, norm(place - fitted.mesh.positions[v]));
    }
  }
  EXPECT_GT(farthest, 1e-3);
  EXPECT_LT(farthest, 0.05);
}

}  // namespace
}  // namespace geolloyd
