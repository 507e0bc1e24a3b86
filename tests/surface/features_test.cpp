#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_measure.h"
#include "core/mesh/mesh_quality.h"
#include "core/shapes/shapes.h"
#include "core/surface/creases/creases.h"
#include "geolloyd/errors.h"
#include "geolloyd/remesh.h"
#include "tests/support/sharp_solids.h"

namespace geolloyd {
namespace {

Remesh remesh_of(const Mesh& mesh, std::size_t vertices, FeatureOptions features = {}) {
  RemeshOptions options;
  options.vertex_count = vertices;
  options.features = std::move(features);
  return remesh(mesh, options, reference_runtime());
}

double area_of(const Mesh& mesh) {
  double area = 0;
  for (const double a : triangle_areas(mesh, {})) area += a;
  return area;
}

bool has_vertex_at(const Mesh& mesh, const Vec3& p) {
  return std::find(mesh.positions.begin(), mesh.positions.end(), p) != mesh.positions.end();
}

double smallest_angle(const Mesh& mesh) {
  return measure_quality(mesh, find_edges(mesh)).smallest_angle;
}

// Of a solid with flat faces: no triangle cuts an edge off, because none is off its face.
void expect_exact(const Mesh& solid, double length, std::size_t vertices) {
  const Remesh remesh = remesh_of(solid, vertices);
  EXPECT_TRUE(remesh.has_input_topology()) << vertices;
  EXPECT_NEAR(area_of(remesh.mesh), area_of(solid), 1e-9) << vertices;
  EXPECT_NEAR(remesh.feature_length(), length, 1e-9) << vertices;
  const std::size_t least = remesh.curve_vertices;
  EXPECT_EQ(remesh.mesh.vertex_count(), std::max(vertices, least)) << vertices;
}

TEST(Features, OfACubeAreExact) {
  for (const std::uint32_t f : {1U, 5U}) {
    const Mesh solid = cube(12 * f * f);
    for (const std::size_t vertices : {50U, 200U}) expect_exact(solid, 12, vertices);
  }
  const Remesh remesh = remesh_of(cube(48), 300);
  for (const Vec3& corner : flat_box(1).positions) EXPECT_TRUE(has_vertex_at(remesh.mesh, corner));
  EXPECT_GE(smallest_angle(remesh.mesh), 28);
}

TEST(Features, OfACubeOfFewVertices) {
  const Remesh remesh = remesh_of(cube(192), 8);
  EXPECT_TRUE(remesh.has_input_topology());
  EXPECT_NEAR(area_of(remesh.mesh), 6, 1e-9);
}

TEST(Features, OfPrismsAreExact) {
  for (const std::uint32_t sides : {3U, 6U}) {
    const double side = 2 * std::sin(std::numbers::pi / sides);
    for (const std::size_t vertices : {150U}) {
      expect_exact(sharp_prism(sides), sides * (2 * side + 2), vertices);
    }
  }
}

// The two rims, and nothing on the smooth side. Their vertices are outside by two thirds of what
// the middles of chords would be inside.
TEST(Features, OfACylinderWithCaps) {
  const Mesh cylinder = sharp_prism(200);
  for (const std::size_t vertices : {250U}) {
    const Remesh remesh = remesh_of(cylinder, vertices);
    EXPECT_TRUE(remesh.has_input_topology());
    EXPECT_EQ(remesh.feature_edges.size(), remesh.curve_vertices);
    EXPECT_NEAR(remesh.feature_length(), 4 * std::numbers::pi, 0.1);
    for (std::size_t v = 0; v < remesh.curve_vertices; ++v) {
      const Vec3& p = remesh.mesh.positions[v];
      EXPECT_NEAR(std::abs(p.z()), 1, 1e-12);
      EXPECT_NEAR(std::hypot(p.x(), p.y()), 1.0075, 0.002);
    }
  }
}

TEST(Features, OfACone) {
  const Remesh remesh = remesh_of(sharp_cone(100), 400);
  EXPECT_TRUE(remesh.has_input_topology());
  EXPECT_NEAR(remesh.feature_length(), 2 * std::numbers::pi, 0.05);
  for (const auto& edge : remesh.feature_edges) {
    for (const VertexId v : edge) EXPECT_NEAR(remesh.mesh.positions[v].z(), 0, 1e-12);
  }
}

// Faces 10 degrees apart have triangles of 10 degrees at their ends, and no smaller ones.
TEST(Features, OfAWedgeHaveNoAngleSmallerThanItsOwn) {
  for (const double degrees : {10.0, 30.0}) {
    const Mesh wedge = sharp_wedge(degrees);
    for (const std::size_t vertices : {150U}) {
      const Remesh remesh = remesh_of(wedge, vertices);
      EXPECT_TRUE(remesh.has_input_topology());
      EXPECT_NEAR(area_of(remesh.mesh), area_of(wedge), 1e-9);
      EXPECT_GE(smallest_angle(remesh.mesh), degrees - 1e-6) << vertices;
    }
  }
}

TEST(Features, AreOffWhereAskedFor) {
  FeatureOptions none;
  none.creases = Creases::none;
  const Remesh remesh = remesh_of(cube(300), 300, none);
  EXPECT_EQ(remesh.curve_vertices, 0U);
  EXPECT_TRUE(remesh.feature_edges.empty());
}

// An octagonal prism turns by 45 degrees at its upright edges.
TEST(Features, AreFoundFromAnAngleOn) {
  const Mesh prism = sharp_prism(8);
  FeatureOptions options;
  options.creases = Creases::by_angle;
  const double rim = 8 * 2 * std::sin(std::numbers::pi / 8);
  options.crease_angle = 40;
  EXPECT_NEAR(remesh_of(prism, 150, options).feature_length(), 2 * rim + 16, 1e-9);
  options.crease_angle = 50;
  EXPECT_NEAR(remesh_of(prism, 150, options).feature_length(), 2 * rim, 1e-9);
  options.crease_angle = 100;
  EXPECT_EQ(remesh_of(prism, 150, options).feature_length(), 0);
}

Mesh with_noise(Mesh mesh, double edges) {
  double sum = 0;
  const MeshEdges found = find_edges(mesh);
  for (const auto& [a, b] : found.ends) sum += norm(mesh.positions[a] - mesh.positions[b]);
  const double reach = edges * sum / static_cast<double>(found.size());
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      const double unit = random_unit(1, 3 * v + static_cast<std::uint64_t>(axis));
      mesh.positions[v][axis] += reach * (2 * unit - 1);
    }
  }
  return mesh;
}

TEST(Features, AreNotFoundInNoise) {
  const Mesh body = creature(20'000, 1);
  const double area = area_of(body);
  for (const double noise : {0.0, 0.1, 0.25, 0.5}) {
    const Mesh rough = with_noise(body, noise);
    const MeshEdges edges = find_edges(rough);
    for (const double vertices : {100.0, 2000.0, 20'000.0, 200'000.0}) {
      const double spacing = std::sqrt(2 * area / (std::sqrt(3.0) * vertices));
      EXPECT_EQ(find_features(rough, edges, {}, spacing).size(), 0U) << noise << " " << vertices;
    }
  }
}

double length_of(const Mesh& mesh, const std::vector<TrianglePair>& creases) {
  double sum = 0;
  for (const auto& [t, u] : creases) {
    std::vector<Vec3> shared;
    for (const VertexId v : mesh.triangles[t]) {
      for (const VertexId w : mesh.triangles[u]) {
        if (v == w) shared.push_back(mesh.positions[v]);
      }
    }
    EXPECT_EQ(shared.size(), 2U);
    sum += norm(shared[0] - shared[1]);
  }
  return sum;
}

// A twelfth of its edges' length is rough; the edges elsewhere are found all the same.
TEST(Features, OfACubeWithNoiseInOnePlace) {
  Mesh solid = cube(12 * 20 * 20);
  const Mesh rough = with_noise(solid, 0.5);
  const Vec3 corner = solid.positions.front();
  for (VertexId v = 0; v < solid.vertex_count(); ++v) {
    if (norm(solid.positions[v] - corner) < 1.0 / 3) solid.positions[v] = rough.positions[v];
  }
  const double length = length_of(solid, find_features(solid, find_edges(solid), {}, 0.1));
  EXPECT_GE(length, 12 - 3 * (1.0 / 3 + 0.1));
  EXPECT_LE(length, 12.5);
}

// A chamfer narrower than edges are long is one crease, a wide one is two.
TEST(Features, OfAChamfer) {
  const double side = std::numbers::sqrt2;
  const auto length_with = [&](double width) {
    const Mesh solid = turned_solid(4, -1, 1, {{1, -1}, {1, 1 - width / side}, {1 - width, 1}});
    return length_of(solid, find_features(solid, find_edges(solid), {}, 0.2));
  };
  EXPECT_NEAR(length_with(0.02), 4 * side + 4 * (2 - 0.02 / side) + 4 * side, 1e-9);
  EXPECT_GT(length_with(0.4), 4 * side + 4 * (2 - 0.4 / side) + 4 * side + 4 * 0.6 * side);
}

// Strips that round the edges above take nothing away from the sharp ones below, nor from upright
// ones, whether they are narrow or wide.
TEST(Features, OfABoxWithAFillet) {
  const double side = std::numbers::sqrt2;
  for (const double radius : {0.01, 0.12, 0.4}) {
    for (const int strips : {4, 6, 10}) {
      std::vector<std::pair<double, double>> profile = {{1, -1}};
      for (int i = 0; i <= strips; ++i) {
        const double angle = i * std::numbers::pi / (2 * strips);
        profile.emplace_back(1 - radius * (1 - std::cos(angle)),
                             1 - radius * (1 - std::sin(angle)));
      }
      const Mesh solid = turned_solid(4, -1, 1, profile);
      for (const double spacing : {0.05, 0.1, 0.3}) {
        const double length =
            length_of(solid, find_features(solid, find_edges(solid), {}, spacing));
        const double sharp = 4 * side + 4 * (2 - radius);
        EXPECT_GE(length, sharp - 1e-9) << radius << " " << strips << " " << spacing;
        EXPECT_LE(length, sharp + 4 * 1.6 * radius) << radius << " " << strips << " " << spacing;
      }
    }
  }
}

// An upright edge ends where a fillet begins that is smaller than edges: what turns aside there
// would be sites too close.
TEST(Features, OfABoxWithATinyFillet) {
  constexpr double radius = 0.01;
  const double side = std::numbers::sqrt2;
  const Mesh solid = turned_solid(4, -1, 1, {{1, -1}, {1, 0.99}, {0.997, 0.997}, {0.99, 1}});
  const double length = length_of(solid, find_features(solid, find_edges(solid), {}, 0.1));
  EXPECT_NEAR(length, 4 * side + 4 * (2 - radius), 1e-9);
}

// Round on both sides of its only edge.
TEST(Features, OfASpindle) {
  for (const std::uint32_t sides : {40U, 300U}) {
    const Mesh solid = turned_solid(sides, -1, 1, {{0.6, 0}});
    const double rim = 2 * sides * 0.6 * std::sin(std::numbers::pi / sides);
    for (const double spacing : {0.02, 0.05, 0.2}) {
      EXPECT_NEAR(length_of(solid, find_features(solid, find_edges(solid), {}, spacing)), rim, 1e-9)
          << sides << " " << spacing;
    }
  }
}

// A row of the chamfer between a cone and a cylinder.
TEST(Features, OfAChamferedShaft) {
  constexpr std::uint32_t sides = 60;
  const Mesh solid = turned_solid(sides, -1, 1, {{0.9, -1}, {1, -0.9}, {1, 1}});
  const double rims = 2 * sides * (0.9 + 1 + 1) * std::sin(std::numbers::pi / sides);
  EXPECT_NEAR(length_of(solid, find_features(solid, find_edges(solid), {}, 0.1)), rims, 1e-9);
}

// A wall or a step that is thinner than edges keeps both of its rims.
TEST(Features, OfAThinPlate) {
  const Mesh plate = pierced_plate(0.5, 0.01, 32);
  const double rims = 2 * (8 + 32 * std::sin(std::numbers::pi / 32));
  EXPECT_NEAR(length_of(plate, find_features(plate, find_edges(plate), {}, 0.1)), rims + 4 * 0.01,
              1e-9);
}

// A plane whose edge turns back by 150 degrees into a strip that is flat or rolled up.
Mesh folded_plane(double turn_of_strip) {
  Mesh mesh;
  constexpr VertexId columns = 40;
  constexpr VertexId rows = 60;
  constexpr double step = 0.1;
  for (VertexId y = 0; y <= rows; ++y) {
    Vec3 at = {0, step * y, 0};
    double heading = 0;
    for (VertexId x = 0; x <= columns; ++x) {
      mesh.positions.push_back(at);
      if (x == columns / 2) heading = 150 * std::numbers::pi / 180;
      if (x > columns / 2) heading -= turn_of_strip;
      at += step * Vec3(std::cos(heading), 0, std::sin(heading));
      if (x == columns || y == rows) continue;
      const VertexId corner = y * (columns + 1) + x;
      mesh.triangles.push_back({corner, corner + 1, corner + columns + 2});
      mesh.triangles.push_back({corner, corner + columns + 2, corner + columns + 1});
    }
  }
  return mesh;
}

// The edge of a knife has two flat sides. A fold of a scan has a curved one.
TEST(Features, OfAFoldAreBetweenFlatSides) {
  const Mesh knife = folded_plane(0);
  EXPECT_NEAR(length_of(knife, find_features(knife, find_edges(knife), {}, 0.5)), 6, 1e-9);
  const Mesh fold = folded_plane(0.2);
  EXPECT_TRUE(find_features(fold, find_edges(fold), {}, 0.5).empty());
}

// A loose edge of a crease that ends on a smooth surface is left out where it is short.
TEST(Features, OfACreaseThatFades) {
  Mesh plane;
  constexpr VertexId columns = 4;
  constexpr VertexId rows = 80;
  for (VertexId y = 0; y <= rows; ++y) {
    for (VertexId x = 0; x <= columns; ++x) {
      const double fold = std::max(0.0, 1 - y / 40.0);  // ends in the middle
      plane.positions.emplace_back(x, y, -2 * fold * std::abs(x - 2.0));
      if (x == columns || y == rows) continue;
      const VertexId at = y * (columns + 1) + x;
      plane.triangles.push_back({at, at + 1, at + columns + 2});
      plane.triangles.push_back({at, at + columns + 2, at + columns + 1});
    }
  }
  const MeshEdges edges = find_edges(plane);
  EXPECT_FALSE(find_features(plane, edges, {}, 0.5).empty());
  EXPECT_TRUE(find_features(plane, edges, {}, 10).empty());
}

// On a sphere, which has no creases: its equator.
TEST(Features, AreBordersBetweenGroups) {
  const Mesh sphere = icosphere(2000);
  FeatureOptions options;
  for (const Triangle& t : sphere.triangles) {
    double height = 0;
    for (const VertexId v : t) height += sphere.positions[v].z();
    options.groups.push_back(height > 0 ? 1 : 0);
  }
  const Remesh remesh = remesh_of(sphere, 200, options);
  EXPECT_TRUE(remesh.has_input_topology());
  EXPECT_EQ(remesh.feature_edges.size(), remesh.curve_vertices);
  EXPECT_NEAR(remesh.feature_length(), 2 * std::numbers::pi, 0.8);
  for (const auto& edge : remesh.feature_edges) {
    for (const VertexId v : edge) EXPECT_NEAR(remesh.mesh.positions[v].z(), 0, 0.1);
  }
}

TEST(Features, AreEdgesThatAreGiven) {
  const Mesh plane = irregular_plane(800, 1);
  FeatureOptions options;
  for (VertexId v = 10; v < 16; ++v) options.edges.push_back({21 * (v + 1) + 10, 21 * v + 10});
  const Remesh remesh = remesh_of(plane, 250, options);
  EXPECT_TRUE(remesh.has_input_topology());
  double length = 0;
  for (const auto& [a, b] : options.edges) {
    length += norm(plane.positions[a] - plane.positions[b]);
  }
  EXPECT_NEAR(remesh.feature_length(), length, 0.1 * length);
  EXPECT_TRUE(has_vertex_at(remesh.mesh, plane.positions[21 * 10 + 10]));
  EXPECT_TRUE(has_vertex_at(remesh.mesh, plane.positions[21 * 16 + 10]));
}

TEST(Features, MustBeOfTheMesh) {
  const Mesh solid = cube(48);
  FeatureOptions options;
  options.edges = {{0, 7}};
  EXPECT_THROW(remesh_of(solid, 100, options), InvalidInput);
  options.edges = {{0, 1'000'000}};
  EXPECT_THROW(remesh_of(solid, 100, options), InvalidInput);
  options.edges = {};
  options.groups = {1, 2, 3};
  EXPECT_THROW(remesh_of(solid, 100, options), InvalidInput);
  options.groups = {};
  options.fixed_vertices = {1'000'000};
  EXPECT_THROW(remesh_of(solid, 100, options), InvalidInput);
  options.fixed_vertices = {};
  options.creases = Creases::by_angle;
  for (const double angle : {0.0, -1.0, 181.0, std::nan("")}) {
    options.crease_angle = angle;
    EXPECT_THROW(remesh_of(solid, 100, options), InvalidInput) << angle;
  }
}

TEST(FixedVertices, AreVerticesOfTheRemesh) {
  for (const Mesh& mesh : {creature(3000, 1), irregular_plane(500, 1), cube(300)}) {
    FeatureOptions options;
    for (VertexId v = 3; v < mesh.vertex_count(); v += 211) options.fixed_vertices.push_back(v);
    options.fixed_vertices.push_back(options.fixed_vertices.front());  // twice
    const Remesh remesh = remesh_of(mesh, 200, options);
    EXPECT_TRUE(remesh.has_input_topology());
    EXPECT_EQ(remesh.mesh.vertex_count(), 200U);
    for (const VertexId v : options.fixed_vertices) {
      EXPECT_TRUE(has_vertex_at(remesh.mesh, mesh.positions[v])) << v;
    }
  }
}

}  // namespace
}  // namespace geolloyd
