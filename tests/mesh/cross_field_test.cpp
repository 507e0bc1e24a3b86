#include "core/fields/cross_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/random.h"
#include "core/base/vec3.h"
#include "core/fields/tangent_plane.h"
#include "core/shapes/shapes.h"

namespace geolloyd {
namespace {

std::vector<TangentSpace> crosses_of(const Mesh& mesh) {
  return cross_field(mesh, find_edges(mesh));
}

Vec3 normal_of(const TangentSpace& s) {
  return cross(s.tangent, s.bitangent);
}

// Sine of the angle between a direction and the nearest arm of a cross.
double sine_to(const TangentSpace& s, const Vec3& direction) {
  return std::min(std::abs(dot(s.tangent, direction)), std::abs(dot(s.bitangent, direction)));
}

void expect_crosses(const std::vector<TangentSpace>& field) {
  for (const TangentSpace& s : field) {
    ASSERT_NEAR(norm(s.tangent), 1, 1e-12);
    ASSERT_NEAR(norm(s.bitangent), 1, 1e-12);
    ASSERT_NEAR(dot(s.tangent, s.bitangent), 0, 1e-12);
    ASSERT_EQ(s.tangent_magnitude, 1);
    ASSERT_EQ(s.bitangent_magnitude, 1);
  }
}

// The largest over the edges.
double widest_turn(const Mesh& mesh, const std::vector<TangentSpace>& field) {
  double widest = 0;
  for (const auto& [a, b] : find_edges(mesh).ends) {
    const Vec3 moved = transported(field[a].tangent, normal_of(field[a]), normal_of(field[b]));
    widest = std::max(widest, sine_to(field[b], moved));
  }
  return widest;
}

TEST(CrossField, FollowsTheSidesOfASquare) {
  const std::vector<TangentSpace> field = crosses_of(irregular_plane(5'000, 1));
  expect_crosses(field);
  for (const TangentSpace& s : field) EXPECT_LT(sine_to(s, Vec3::UnitX()), 0.02);
}

TEST(CrossField, FollowsTheEdgesOfACube) {
  const Mesh mesh = cube(6'000);
  const std::vector<TangentSpace> field = crosses_of(mesh);
  expect_crosses(field);
  std::size_t along = 0;
  for (const TangentSpace& s : field) {
    const double sine = std::max({std::min(sine_to(s, Vec3::UnitX()), sine_to(s, Vec3::UnitY())),
                                  std::min(sine_to(s, Vec3::UnitY()), sine_to(s, Vec3::UnitZ()))});
    along += sine < 0.1 ? 1 : 0;
  }
  EXPECT_GT(along, field.size() * 97 / 100);
}

// There every circle is a line of curvature.
TEST(CrossField, FollowsCurvatureOnATorus) {
  const Mesh mesh = torus(5'000, 1);
  const std::vector<TangentSpace> field = crosses_of(mesh);
  expect_crosses(field);
  for (std::size_t v = 0; v < field.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    const double axis_distance = std::sqrt(p.x() * p.x() + p.y() * p.y());
    const Vec3 around = Vec3(-p.y(), p.x(), 0) / axis_distance;
    EXPECT_LT(sine_to(field[v], around), 0.2);
  }
}

// A sphere has eight places, at least, where a cross cannot be smooth.
TEST(CrossField, IsSmoothOnASphereButForAFewPlaces) {
  const Mesh mesh = icosphere(5'000);
  const std::vector<TangentSpace> field = crosses_of(mesh);
  expect_crosses(field);
  std::size_t turning = 0;
  const MeshEdges edges = find_edges(mesh);
  for (const auto& [a, b] : edges.ends) {
    const Vec3 moved = transported(field[a].tangent, normal_of(field[a]), normal_of(field[b]));
    turning += sine_to(field[b], moved) > 0.2 ? 1 : 0;
  }
  EXPECT_GT(turning, 8U);
  EXPECT_LT(turning, edges.size() / 50);
}

TEST(CrossField, TurnsLittleFromVertexToVertexOnATorus) {
  const Mesh mesh = torus(5'000, 1);
  EXPECT_LT(widest_turn(mesh, crosses_of(mesh)), 0.2);
}

TEST(CrossField, HasItsBits) {
  std::uint64_t all = 0;
  for (const TangentSpace& s : crosses_of(torus(500, 1))) {
    for (const Vec3& v : {s.tangent, s.bitangent}) {
      for (const double x : v) all = mix_bits(all ^ std::bit_cast<std::uint64_t>(x));
    }
  }
  EXPECT_EQ(all, 13935019234883106269U);
}

// Vertices of no triangle, a star of triangles at one vertex, flipped triangles, many parts.
TEST(CrossField, HasACrossForEachVertexOfAnyMesh) {
  Mesh lonely = irregular_plane(200, 1);
  lonely.positions.resize(2'000, Vec3(3, 4, 5));
  expect_crosses(crosses_of(lonely));

  Mesh fan{{{0, 0, 0}}, {}};
  for (VertexId v = 0; v < 1'000; ++v) {
    const double turn = 0.001 * v * 6;
    fan.positions.emplace_back(std::cos(turn), std::sin(turn), 0);
    if (v > 0) fan.triangles.push_back({0, v, v + 1});
  }
  expect_crosses(crosses_of(fan));

  Mesh flipped = icosphere(320);
  for (std::size_t t = 0; t < flipped.triangle_count(); t += 2) {
    std::swap(flipped.triangles[t][0], flipped.triangles[t][1]);
  }
  expect_crosses(crosses_of(flipped));

  Mesh parts;
  for (VertexId v = 0; v < 900; v += 3) {
    for (VertexId i = 0; i < 3; ++i) parts.positions.emplace_back(v, i == 1, i == 2);
    parts.triangles.push_back({v, v + 1, v + 2});
  }
  expect_crosses(crosses_of(parts));

  expect_crosses(crosses_of({{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}}));
}

}  // namespace
}  // namespace geolloyd
