#include "core/fields/curvature_field.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

#include "core/base/random.h"
#include "core/base/vec3.h"
#include "core/mesh/mesh_measure.h"
#include "core/mesh/subdivide.h"
#include "core/shapes/shapes.h"

namespace geolloyd {
namespace {

std::vector<TangentSpace> field_of(const Mesh& mesh) {
  return curvature_field(mesh, find_edges(mesh));
}

double ratio(const TangentSpace& s) {
  return s.tangent_magnitude / s.bitangent_magnitude;
}

double bounding_size(const Mesh& mesh) {
  Vec3 low = mesh.positions[0];
  Vec3 high = low;
  for (const Vec3& p : mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return norm(high - low);
}

Mesh shaken(Mesh mesh, double share) {
  const double reach = share * bounding_size(mesh);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    for (int i = 0; i < 3; ++i) {
      mesh.positions[v][i] += reach * (2 * random_unit(3, 3 * v + static_cast<std::size_t>(i)) - 1);
    }
  }
  return mesh;
}

// Unit vectors at right angles, magnitudes in order and within the limit, and the mean scale 1.
void expect_sound(const Mesh& mesh, const std::vector<TangentSpace>& field) {
  ASSERT_EQ(field.size(), mesh.vertex_count());
  const std::vector<double> area = vertex_areas(mesh, {});
  double whole = 0;
  double in_metric = 0;
  for (std::size_t v = 0; v < field.size(); ++v) {
    const TangentSpace& s = field[v];
    ASSERT_NEAR(norm(s.tangent), 1, 1e-12);
    ASSERT_NEAR(norm(s.bitangent), 1, 1e-12);
    ASSERT_NEAR(dot(s.tangent, s.bitangent), 0, 1e-12);
    ASSERT_GE(ratio(s), 1);
    ASSERT_LE(ratio(s), most_stretch * (1 + 1e-12));
    whole += area[v];
    in_metric += area[v] * s.tangent_magnitude * s.bitangent_magnitude;
  }
  EXPECT_NEAR(in_metric / whole, 1, 1e-9);
}

// The largest angle, in degrees, between the first direction and the true one.
double largest_angle(const Mesh& mesh, const std::vector<TangentSpace>& field,
                     const std::function<Vec3(const Vec3&)>& truth) {
  double largest = 0;
  for (std::size_t v = 0; v < field.size(); ++v) {
    const Vec3 expected = truth(mesh.positions[v]);
    const double sine = norm(cross(field[v].tangent, expected));
    largest = std::max(largest, std::asin(std::min(sine, 1.0)) * 180 / std::numbers::pi);
  }
  return largest;
}

TEST(CurvatureField, OfASphereIsIsotropic) {
  const Mesh mesh = icosphere(5000);
  const auto field = field_of(mesh);
  expect_sound(mesh, field);
  for (const TangentSpace& s : field) {
    EXPECT_LT(ratio(s), 1.1);
    EXPECT_NEAR(s.tangent_magnitude, 1, 0.1);
  }
}

TEST(CurvatureField, OfAPlaneIsIsotropic) {
  const Mesh mesh = irregular_plane(2000, 1);
  const auto field = field_of(mesh);
  expect_sound(mesh, field);
  for (const TangentSpace& s : field) {
    EXPECT_EQ(s.tangent_magnitude, 1);
    EXPECT_EQ(s.bitangent_magnitude, 1);
  }
}

TEST(CurvatureField, OfACylinderGoesAroundAtTheLimit) {
  const Mesh mesh = cylinder(5000, 1);
  const auto field = field_of(mesh);
  expect_sound(mesh, field);
  const auto around = [](const Vec3& p) { return normalized({-p.y(), p.x(), 0}); };
  EXPECT_LT(largest_angle(mesh, field, around), 3);
  for (const TangentSpace& s : field) EXPECT_NEAR(ratio(s), most_stretch, 0.2);
}

// Of radii R and r: curvatures 1 / r along the meridian, and cos / (R + r cos) around.
TEST(CurvatureField, OfATorusGoesAlongMeridians) {
  for (const double noise : {0.0, 0.001}) {
    const Mesh mesh = shaken(torus(8000, 1), noise);
    const auto field = field_of(mesh);
    expect_sound(mesh, field);
    const auto meridian = [](const Vec3& p) {
      return cross(normalized({-p.y(), p.x(), 0}), normalized(p - normalized({p.x(), p.y(), 0})));
    };
    EXPECT_LT(largest_angle(mesh, field, meridian), noise > 0 ? 15 : 8);
  }
}

TEST(CurvatureField, DependsNeitherOnScaleNorOnOrientation) {
  const Mesh mesh = torus(1000, 1);
  const auto expected = field_of(mesh);
  Mesh other = mesh;
  for (Vec3& p : other.positions) p *= 1024;
  const auto scaled = field_of(other);
  other = mesh;
  for (std::size_t t = 0; t < other.triangle_count(); t += 3) {
    std::swap(other.triangles[t][0], other.triangles[t][1]);
  }
  const auto mixed = field_of(other);
  for (std::size_t v = 0; v < expected.size(); ++v) {
    EXPECT_EQ(scaled[v].tangent_magnitude, expected[v].tangent_magnitude);
    EXPECT_NEAR(mixed[v].tangent_magnitude, expected[v].tangent_magnitude, 1e-9);
    EXPECT_NEAR(norm(cross(mixed[v].tangent, expected[v].tangent)), 0, 1e-6);
  }
}

Mesh moebius_strip(std::uint32_t quads) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < quads; ++i) {
    const double turn = 2 * std::numbers::pi * i / quads;
    for (const double side : {-0.3, 0.0, 0.3}) {
      const double out = 1 + side * std::cos(turn / 2);
      mesh.positions.emplace_back(out * std::cos(turn), out * std::sin(turn),
                                  side * std::sin(turn / 2));
    }
  }
  for (std::uint32_t i = 0; i < quads; ++i) {
    for (std::uint32_t row = 0; row < 2; ++row) {
      const bool is_last = i + 1 == quads;
      const auto next = [&](std::uint32_t k) { return is_last ? 2 - k : 3 * (i + 1) + k; };
      mesh.triangles.push_back({3 * i + row, next(row), 3 * i + row + 1});
      mesh.triangles.push_back({3 * i + row + 1, next(row), next(row + 1)});
    }
  }
  return mesh;
}

// It has no orientation, and yet the field goes on across every edge.
TEST(CurvatureField, OfAMoebiusStripHasNoSeam) {
  const Mesh mesh = refine(moebius_strip(120), 2);
  const auto field = field_of(mesh);
  expect_sound(mesh, field);
  for (const auto& [a, b] : find_edges(mesh).ends) {
    EXPECT_NEAR(field[a].tangent_magnitude / field[b].tangent_magnitude, 1, 0.2);
  }
}

// The same on every machine.
TEST(CurvatureField, HasItsBits) {
  std::uint64_t all = 0;
  for (const TangentSpace& s : field_of(shaken(torus(500, 1), 0.01))) {
    for (const Vec3& v :
         {s.tangent, s.bitangent, Vec3(s.tangent_magnitude, s.bitangent_magnitude, 0)}) {
      for (const double x : v) all = mix_bits(all ^ std::bit_cast<std::uint64_t>(x));
    }
  }
  EXPECT_EQ(all, 5921697165897902166U);
}

TEST(CurvatureField, OfOddMeshesIsSound) {
  // no triangle; one; a triangle twice; a fold; three at an edge; without area; a loose vertex
  const std::vector<Vec3> p = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}, {5, 5, 5}};
  const std::vector<std::vector<Triangle>> soups = {
      {},
      {{0, 1, 2}},
      {{0, 1, 2}, {0, 1, 2}},
      {{0, 1, 2}, {1, 0, 2}},
      {{0, 1, 2}, {0, 1, 3}, {0, 1, 5}},
      {{0, 1, 4}},
      {{0, 1, 4}, {0, 1, 2}, {1, 1, 3}},
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}},
  };
  for (const auto& triangles : soups) {
    const auto field = field_of({p, triangles});
    for (const TangentSpace& s : field) {
      EXPECT_NEAR(norm(s.tangent), 1, 1e-12);
      EXPECT_NEAR(norm(s.bitangent), 1, 1e-12);
      EXPECT_GT(s.bitangent_magnitude, 0);
      EXPECT_LT(s.tangent_magnitude, 100);
    }
  }
}

}  // namespace
}  // namespace geolloyd
