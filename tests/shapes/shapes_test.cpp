#include "core/shapes/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "core/mesh/mesh_edges.h"
#include "geolloyd/errors.h"
#include "tests/support/doubled_area.h"

namespace geolloyd {
namespace {

struct Family {
  std::string name;
  std::function<Mesh(std::size_t, std::uint64_t)> make;
  std::vector<std::pair<std::size_t, std::size_t>> counts;  // asked for, made
  int euler_characteristic;
  bool closed;
  bool random;
};

std::ostream& operator<<(std::ostream& out, const Family& family) {
  return out << family.name;
}

const std::vector<Family>& families() {
  static const std::vector<Family> all = {
      {"plane",
       irregular_plane,
       {{1, 2}, {2, 2}, {3, 8}, {8, 8}, {9, 18}, {45'000, 45'000}, {45'001, 45'602}},
       1,
       false,
       true},
      {"sphere",
       [](std::size_t triangles, std::uint64_t) { return icosphere(triangles); },
       {{1, 20}, {20, 20}, {21, 80}, {80, 80}, {81, 180}, {20'000, 20'480}},
       2,
       true,
       false},
      {"cube",
       [](std::size_t triangles, std::uint64_t) { return cube(triangles); },
       {{1, 12}, {12, 12}, {13, 48}, {20'000, 20'172}},
       2,
       true,
       false},
      {"torus", torus, {{1, 80}, {80, 80}, {81, 180}, {180, 180}, {20'000, 20'480}}, 0, true, true},
      {"cylinder",
       cylinder,
       {{1, 24}, {24, 24}, {25, 54}, {54, 54}, {20'000, 20'184}},
       0,
       false,
       true},
      {"creature",
       creature,
       {{1, 2'364}, {2'364, 2'364}, {2'365, 9'456}, {20'000, 21'276}},
       2,
       true,
       true},
  };
  return all;
}

double signed_volume(const Mesh& mesh) {
  double volume = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    volume += dot(mesh.positions[a], cross(mesh.positions[b], mesh.positions[c])) / 6;
  }
  return volume;
}

double smallest_angle(const Mesh& mesh, const Triangle& t) {
  double cosine = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = mesh.positions[t[i]];
    const Vec3 b = normalized(mesh.positions[t[(i + 1) % 3]] - a);
    const Vec3 c = normalized(mesh.positions[t[(i + 2) % 3]] - a);
    cosine = std::max(cosine, dot(b, c));
  }
  return std::acos(cosine);
}

class EachFamily : public testing::TestWithParam<Family> {};

TEST_P(EachFamily, MakesTheSmallestMemberWithEnoughTriangles) {
  for (const auto& [asked, made] : GetParam().counts) {
    EXPECT_EQ(GetParam().make(asked, 7).triangle_count(), made) << asked << " asked for";
  }
}

TEST_P(EachFamily, IsAnOrientedManifold) {
  for (const auto& [asked, made] : GetParam().counts) {
    const Mesh mesh = GetParam().make(asked, 7);
    const MeshEdges edges = find_edges(mesh);
    std::size_t boundary = 0;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto corners = edges.corners(e);
      ASSERT_LE(corners.size(), 2U);
      if (corners.size() == 1) {
        ++boundary;
      } else {
        ASSERT_EQ(edge_start(mesh, corners[0]), edge_end(mesh, corners[1]));
      }
    }
    const auto characteristic =
        static_cast<std::int64_t>(mesh.vertex_count() + mesh.triangle_count()) -
        static_cast<std::int64_t>(edges.size());
    EXPECT_EQ(characteristic, GetParam().euler_characteristic) << asked << " asked for";
    EXPECT_EQ(boundary == 0, GetParam().closed);
  }
}

TEST_P(EachFamily, LooksOutwardsWhereItIsClosed) {
  if (!GetParam().closed) return;
  for (const auto& [asked, made] : GetParam().counts) {
    EXPECT_GT(signed_volume(GetParam().make(asked, 7)), 0);
  }
}

TEST_P(EachFamily, HasNoSlivers) {
  for (const std::uint64_t random_seed : {0U, 1U, 2U}) {
    const Mesh mesh = GetParam().make(20'000, random_seed);
    double sum = 0;
    for (const Triangle& t : mesh.triangles) {
      ASSERT_TRUE(has_three_vertices(t));
      const double angle = smallest_angle(mesh, t);
      ASSERT_GT(angle, 0.05);
      sum += angle;
    }
    EXPECT_GT(sum / static_cast<double>(mesh.triangle_count()), 0.6);
  }
}

TEST_P(EachFamily, HasFloatCoordinates) {
  const Mesh mesh = GetParam().make(5'000, 3);
  for (const Vec3& p : mesh.positions) {
    for (const double x : p) {
      const volatile auto rounded = static_cast<float>(x);  // volatile: see rounded_to_float
      ASSERT_EQ(x, rounded);
    }
  }
}

TEST_P(EachFamily, DependsOnItsArgumentsOnly) {
  const Mesh mesh = GetParam().make(5'000, 3);
  const Mesh again = GetParam().make(5'000, 3);
  EXPECT_EQ(mesh.positions, again.positions);
  EXPECT_EQ(mesh.triangles, again.triangles);
  const Mesh other = GetParam().make(5'000, 4);
  EXPECT_EQ(other.triangle_count(), mesh.triangle_count());
  EXPECT_EQ(other.positions != mesh.positions, GetParam().random);
}

TEST_P(EachFamily, RefusesImpossibleCounts) {
  EXPECT_THROW(GetParam().make(0, 1), InvalidInput);
  EXPECT_THROW(GetParam().make(no_id / 3, 1), InvalidInput);  // none has exactly as many
  EXPECT_THROW(GetParam().make(std::size_t{no_id} + 1, 1), InvalidInput);
  EXPECT_THROW(GetParam().make(std::numeric_limits<std::size_t>::max(), 1), InvalidInput);
}

INSTANTIATE_TEST_SUITE_P(Shapes, EachFamily, testing::ValuesIn(families()),
                         [](const auto& instance) { return instance.param.name; });

TEST(IrregularPlane, TilesTheUnitSquareUpright) {
  for (const std::size_t triangles : {1U, 8U, 1'000U, 100'000U}) {
    for (const std::uint64_t random_seed : {0U, 1U, 2U}) {
      const Mesh mesh = irregular_plane(triangles, random_seed);
      double area = 0;
      for (const Triangle& t : mesh.triangles) {
        const Vec3 normal = doubled_area(mesh, t);
        ASSERT_GT(normal.z(), 0);
        area += normal.z() / 2;
      }
      EXPECT_NEAR(area, 1, 1e-12);
    }
  }
}

TEST(IrregularPlane, StaysFlatInTheUnitSquareWithItsCorners) {
  const Mesh mesh = irregular_plane(5'000, 1);
  const std::size_t side = 51;
  ASSERT_EQ(mesh.vertex_count(), side * side);
  EXPECT_EQ(mesh.positions.front(), Vec3(0, 0, 0));
  EXPECT_EQ(mesh.positions[side - 1], Vec3(1, 0, 0));
  EXPECT_EQ(mesh.positions[side * (side - 1)], Vec3(0, 1, 0));
  EXPECT_EQ(mesh.positions.back(), Vec3(1, 1, 0));
  for (const Vec3& p : mesh.positions) {
    ASSERT_TRUE(p.x() >= 0 && p.x() <= 1 && p.y() >= 0 && p.y() <= 1 && p.z() == 0);
  }
}

TEST(Icosphere, LiesOnTheUnitSphereAndIsEven) {
  const Mesh mesh = icosphere(20'000);
  for (const Vec3& p : mesh.positions) ASSERT_NEAR(norm(p), 1, 1e-7);
  double shortest = 1;
  double longest = 0;
  for (const auto& [a, b] : find_edges(mesh).ends) {
    const double length = norm(mesh.positions[a] - mesh.positions[b]);
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
  EXPECT_LT(longest / shortest, 1.2);
}

TEST(Icosphere, OfTwentyTrianglesIsTheIcosahedron) {
  const Mesh mesh = icosphere(20);
  ASSERT_EQ(mesh.vertex_count(), 12U);
  for (const auto& [a, b] : find_edges(mesh).ends) {
    EXPECT_NEAR(dot(mesh.positions[a], mesh.positions[b]), 1 / std::sqrt(5.0), 1e-7);
  }
}

TEST(Torus, LiesOnTheTorus) {
  for (const Vec3& p : torus(20'000, 5).positions) {
    ASSERT_NEAR(std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()), 0.4, 1e-7);
  }
}

TEST(Torus, HasNearlyTheAreaOfTheTorus) {
  const double pi = 3.141592653589793;
  const Mesh mesh = torus(100'000, 5);
  double area = 0;
  for (const Triangle& t : mesh.triangles) area += norm(doubled_area(mesh, t)) / 2;
  EXPECT_NEAR(area, 4 * pi * pi * 0.4, 0.01);
}

TEST(Cylinder, LiesOnTheCylinderBetweenItsRims) {
  const Mesh mesh = cylinder(20'000, 5);
  for (const Vec3& p : mesh.positions) {
    ASSERT_NEAR(std::hypot(p.x(), p.y()), 1, 1e-7);
    ASSERT_LE(std::abs(p.z()), 1);
  }
  for (std::size_t i = 0; i < 174; ++i) {
    ASSERT_EQ(mesh.positions[i].z(), -1);
    ASSERT_EQ(mesh.positions[mesh.vertex_count() - 1 - i].z(), 1);
  }
}

TEST(Cylinder, LooksOutwardsAndHasNearlyItsArea) {
  const double pi = 3.141592653589793;
  const Mesh mesh = cylinder(100'000, 5);
  double area = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 normal = doubled_area(mesh, t);
    ASSERT_GT(dot(normal, mesh.positions[t[0]]), mesh.positions[t[0]].z() * normal.z());
    area += norm(normal) / 2;
  }
  EXPECT_NEAR(area, 4 * pi, 0.005);
}

TEST(Creature, IsAboutOneUnitLong) {
  for (const std::uint64_t random_seed : {1U, 2U, 3U}) {
    Vec3 low = Vec3::Constant(1);
    Vec3 high = -low;
    for (const Vec3& p : creature(20'000, random_seed).positions) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    EXPECT_NEAR((high - low).x(), 1, 0.1);
    EXPECT_LT((high - low).y(), 0.6);
    EXPECT_NEAR((high - low).z(), 0.8, 0.1);
  }
}

// All members lie on one smooth skin: they enclose the same volume but for their facets.
TEST(Creature, KeepsItsShapeWhenRefined) {
  const double fine = signed_volume(creature(600'000, 1));
  const double finer = signed_volume(creature(2'400'000, 1));
  EXPECT_NEAR(fine, finer, 1e-4 * finer);
}

}  // namespace
}  // namespace geolloyd
