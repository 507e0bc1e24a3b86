#include "core/surface/sizing/sizing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/mesh/mesh_measure.h"
#include "core/mesh/mesh_quality.h"
#include "core/shapes/shapes.h"
#include "core/surface/sizing/curvature.h"
#include "core/surface/sizing/growth_limit.h"
#include "geolloyd/errors.h"
#include "tests/support/odd_surfaces.h"
#include "tests/support/random_graph.h"
#include "tests/support/sharp_solids.h"
#include "tests/support/surface.h"

namespace geolloyd {
namespace {

template <class Length>
std::vector<double> at_vertices(const Mesh& mesh, Length&& length) {
  std::vector<double> values;
  for (const Vec3& p : mesh.positions) values.push_back(length(p));
  return values;
}

RemeshOptions options_with(const SizingOptions& sizing, std::size_t vertices = 0) {
  RemeshOptions options;
  options.sizing = sizing;
  options.vertex_count = vertices;
  return options;
}

// Of each edge: its length over what `length` says at its middle.
template <class Length>
std::vector<double> sorted_ratios(const Mesh& remesh, Length&& length) {
  std::vector<double> ratios;
  for (const auto& [a, b] : find_edges(remesh).ends) {
    const Vec3& p = remesh.positions[a];
    const Vec3& q = remesh.positions[b];
    ratios.push_back(norm(p - q) / length((p + q) / 2));
  }
  std::sort(ratios.begin(), ratios.end());
  return ratios;
}

double share_within_a_third(const std::vector<double>& ratios) {
  const auto count = std::count_if(ratios.begin(), ratios.end(),
                                   [](double r) { return std::abs(r - 1) <= 1.0 / 3; });
  return static_cast<double>(count) / static_cast<double>(ratios.size());
}

void expect_follows(const std::vector<double>& ratios) {
  EXPECT_NEAR(ratios[ratios.size() / 2], 1, 0.05);
  EXPECT_GE(share_within_a_third(ratios), 0.95);
}

// Each length is the least of what the vertices allow, along all paths.
std::vector<double> limited_by_force(const Mesh& mesh, double growth, std::vector<double> lengths) {
  const MeshEdges edges = find_edges(mesh);
  for (bool changes = true; changes;) {
    changes = false;
    for (const auto& edge : edges.ends) {
      const double way = norm(mesh.positions[edge[0]] - mesh.positions[edge[1]]);
      for (const std::size_t i : {0U, 1U}) {
        const double limit = lengths[edge[i]] + (growth - 1) * way;
        if (!(limit < lengths[edge[1 - i]])) continue;
        lengths[edge[1 - i]] = limit;
        changes = true;
      }
    }
  }
  return lengths;
}

TEST(Sizing, LimitsGrowthByTheShortestPaths) {
  const Mesh mesh = irregular_plane(600, 1);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    std::vector<double> lengths;
    for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
      lengths.push_back(0.01 + random_unit(seed, v) * random_unit(seed + 100, v));
    }
    const std::vector<double> expected = limited_by_force(mesh, 1.2, lengths);
    std::vector<double> limited = lengths;
    limit_growth(mesh, find_edges(mesh), 1.2, limited);
    EXPECT_EQ(limited, expected) << seed;
    EXPECT_NE(limited, lengths);
    std::vector<double> steep = lengths;
    limit_growth(mesh, find_edges(mesh), std::numeric_limits<double>::infinity(), steep);
    EXPECT_EQ(steep, lengths);
  }
}

TEST(Sizing, CountsTheSitesOfAField) {
  const Mesh mesh = irregular_plane(20'000, 1);
  const auto ramp = [](const Vec3& p) { return 0.02 + 0.1 * p.x(); };
  SizingOptions sizing;
  sizing.edge_lengths = at_vertices(mesh, ramp);
  const Sizing found =
      find_sizing(mesh, find_edges(mesh), sizing.edge_lengths, options_with(sizing));
  // The integral of 2 / (sqrt(3) (0.02 + 0.1 x)^2).
  const double expected = 2 / std::sqrt(3) * (1 / 0.02 - 1 / 0.12) / 0.1;
  EXPECT_NEAR(sites_at(1, found.spacing), expected, 0.005 * expected);
  for (VertexId v = 0; v < mesh.vertex_count(); v += 100) {
    EXPECT_NEAR(found.sizes[v] * found.spacing, sizing.edge_lengths[v],
                1e-12 * sizing.edge_lengths[v]);
  }
}

TEST(Sizing, ScalesAFieldToACountOrAMeanLength) {
  const Mesh mesh = irregular_plane(5000, 1);
  const auto steep = [](const Vec3& p) { return 1 + 100 * p.x() * p.x(); };
  SizingOptions sizing;
  sizing.edge_lengths = at_vertices(mesh, steep);
  RemeshOptions options = options_with(sizing, 700);
  const MeshEdges edges = find_edges(mesh);
  EXPECT_NEAR(sites_at(1, find_sizing(mesh, edges, sizing.edge_lengths, options).spacing), 700,
              1e-6);
  options.vertex_count = 0;
  options.edge_length = 0.03;
  const Remesh made = remesh(mesh, options, reference_runtime());
  double sum = 0;
  const MeshEdges made_edges = find_edges(made.mesh);
  for (const auto& [a, b] : made_edges.ends) {
    sum += norm(made.mesh.positions[a] - made.mesh.positions[b]);
  }
  EXPECT_NEAR(sum / static_cast<double>(made_edges.size()), 0.03, 0.03 * 0.02);
}

TEST(Sizing, OfAPlaneFollowsALinearField) {
  const Mesh mesh = irregular_plane(5000, 1);
  const auto ramp = [](const Vec3& p) { return 0.02 + 0.06 * p.x(); };
  SizingOptions sizing;
  sizing.edge_lengths = at_vertices(mesh, ramp);
  const Remesh made = remesh(mesh, options_with(sizing), reference_runtime());
  EXPECT_TRUE(made.has_input_topology());
  expect_follows(sorted_ratios(made.mesh, ramp));
  const MeshQuality quality = measure_quality(made.mesh, find_edges(made.mesh));
  EXPECT_GE(quality.smallest_angle, 30);
  ASSERT_EQ(made.edge_lengths.size(), made.mesh.vertex_count());
  for (std::size_t v = 0; v < made.edge_lengths.size(); ++v) {
    EXPECT_NEAR(made.edge_lengths[v], ramp(made.mesh.positions[v]), 1e-3);
  }
  EXPECT_NEAR(made.energy / made.energy_of_hexagonal_tiling, 1.06, 0.06);
}

// Two triangles have sizes at four vertices only, between which they are linear.
TEST(Sizing, OfACoarsePlaneFollowsALinearField) {
  Mesh square;
  square.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto ramp = [](const Vec3& p) { return 0.02 + 0.08 * p.x(); };
  SizingOptions sizing;
  sizing.edge_lengths = at_vertices(square, ramp);
  const Remesh made = remesh(square, options_with(sizing), reference_runtime());
  EXPECT_TRUE(made.has_input_topology());
  expect_follows(sorted_ratios(made.mesh, ramp));
}

TEST(Sizing, OfACubeKeepsItsEdges) {
  const Mesh mesh = cube(3000);
  const auto length = [](const Vec3& p) { return 0.05 + 0.1 * p.z(); };
  SizingOptions sizing;
  sizing.edge_lengths = at_vertices(mesh, length);
  const Remesh made = remesh(mesh, options_with(sizing), reference_runtime());
  EXPECT_TRUE(made.has_input_topology());
  EXPECT_NEAR(made.feature_length(), 12, 1e-9);
  expect_follows(sorted_ratios(made.mesh, length));
}

// Lengths are powers of two, and densities of sixteen, whose roots are exact.
TEST(Sizing, OfDensitiesIsThatOfLengths) {
  const Mesh mesh = torus(2000, 1);
  SizingOptions by_length;
  by_length.edge_lengths = at_vertices(mesh, [](const Vec3& p) { return p.x() > 0 ? 1.0 : 2.0; });
  SizingOptions by_density;
  for (const double length : by_length.edge_lengths) {
    by_density.densities.push_back(3 / (3 * length * length * length * length));
  }
  EXPECT_EQ(remesh(mesh, options_with(by_density, 200), reference_runtime()).fingerprint,
            remesh(mesh, options_with(by_length, 200), reference_runtime()).fingerprint);
}

TEST(Sizing, OfOneLengthIsEven) {
  const Mesh mesh = icosphere(5000);
  SizingOptions sizing;
  sizing.edge_lengths = at_vertices(mesh, [](const Vec3&) { return 7.0; });
  const Remesh made = remesh(mesh, options_with(sizing, 300), reference_runtime());
  EXPECT_EQ(made.mesh.vertex_count(), 300U);
  EXPECT_LE(made.energy / made.energy_of_hexagonal_tiling, 1.02);
  RemeshOptions even;
  even.vertex_count = 300;
  EXPECT_TRUE(remesh(mesh, even, reference_runtime()).edge_lengths.empty());
}

TEST(Sizing, AdaptsNothingWhereCurvatureIsTheSame) {
  for (const Mesh& mesh : {icosphere(8000), irregular_plane(5000, 1), sharp_prism(4)}) {
    SizingOptions sizing;
    sizing.adapt = 1;
    const Remesh made = remesh(mesh, options_with(sizing, 200), reference_runtime());
    const auto [least, most] =
        std::minmax_element(made.edge_lengths.begin(), made.edge_lengths.end());
    EXPECT_LE(*most, 1.1 * *least) << mesh.vertex_count();
  }
}

// Large where it is flat, small at the sharp end.
TEST(Sizing, AdaptsToAnEllipsoid) {
  Mesh mesh = icosphere(20'000);
  for (Vec3& p : mesh.positions) p.x() *= 4;
  SizingOptions sizing;
  sizing.adapt = 1;
  const Remesh made = remesh(mesh, options_with(sizing, 400), reference_runtime());
  double at_tip = 0;
  double at_waist = 0;
  double tips = 0;
  double waists = 0;
  for (std::size_t v = 0; v < made.edge_lengths.size(); ++v) {
    const double x = std::abs(made.mesh.positions[v].x());
    if (x > 3.7) at_tip += made.edge_lengths[v], ++tips;
    if (x < 1) at_waist += made.edge_lengths[v], ++waists;
  }
  ASSERT_GT(tips, 0);
  // Principal curvatures are 4 and 4 at the tip, 1 and 1/16 at the waist; the tip is small, so that
  // averages blunt it.
  EXPECT_GT(at_waist / waists, 1.4 * at_tip / tips);
  EXPECT_LT(at_waist / waists, 2.4 * at_tip / tips);
}

TEST(Curvature, OfATorusIsWhatItIs) {
  const Mesh mesh = torus(30'000, 1);
  const SurfaceInput input = surface_input_of(mesh);
  const std::vector<double> found = relative_curvatures(mesh, input, 0.1);
  const auto square_at = [](const Vec3& p) {  // radii 1 and 0.4
    const double along = (std::hypot(p.x(), p.y()) - 1) / 0.4;
    const double across = along / (1 + 0.4 * along);
    return 1 / 0.16 + across * across;
  };
  // The mean of the squares over the surface, whose area is in proportion to 1 + 0.4 cos.
  double mean = 0;
  constexpr int steps = 1000;
  for (int i = 0; i < steps; ++i) {
    const double c = std::cos(2 * std::numbers::pi * i / steps);
    mean += (1 + 0.4 * c) * (1 / 0.16 + c * c / ((1 + 0.4 * c) * (1 + 0.4 * c))) / steps;
  }
  double sum = 0;
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    const double expected = std::sqrt(square_at(mesh.positions[v]) / mean);
    EXPECT_NEAR(found[v], expected, 0.25 * expected);
    sum += found[v] / expected;
  }
  EXPECT_NEAR(sum / static_cast<double>(mesh.vertex_count()), 1, 0.02);
}

TEST(Sizing, RefusesWhatIsNoSize) {
  const Mesh mesh = icosphere(80);
  const auto refused = [&](const SizingOptions& sizing, const std::string& what) {
    try {
      remesh(mesh, options_with(sizing, 20), reference_runtime());
    } catch (const InvalidInput& error) {
      EXPECT_EQ(std::string(error.what()).find(what), 0U) << error.what();
      return true;
    }
    return false;
  };
  SizingOptions sizing;
  sizing.edge_lengths.assign(mesh.vertex_count() - 1, 1);
  EXPECT_TRUE(refused(sizing, "edge_lengths: 41 values, but the mesh has 42 vertices"));
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    sizing.edge_lengths.assign(mesh.vertex_count(), 1);
    sizing.edge_lengths[7] = bad;
    EXPECT_TRUE(refused(sizing, "edge_lengths: vertex 7 has")) << bad;
  }
  sizing.edge_lengths[7] = 1e-9;
  sizing.growth = 1e9;
  EXPECT_TRUE(refused(sizing, "edge lengths: the longest is"));
  sizing.adapt = 1;
  EXPECT_TRUE(refused(sizing, "edge_lengths, densities, adapt and equal_error: "));
  EXPECT_TRUE(refused({{}, {}, 1, 1.12, true}, "edge_lengths, densities, adapt and equal_error: "));
  for (const double bad : {-1.0, 2.1, std::nan("")}) {
    EXPECT_TRUE(refused({{}, {}, bad, 1.3}, "adapt: ")) << bad;
  }
  for (const double bad : {1.0, -1.0, std::nan("")}) {
    EXPECT_TRUE(refused({{}, {}, 1, bad}, "growth: "));
  }
  EXPECT_THROW(remesh(mesh, options_with({{}, {}, 1, 1.3}), reference_runtime()), InvalidInput);
}

}  // namespace
}  // namespace geolloyd
