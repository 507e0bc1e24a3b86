#include "core/mesh/mesh_quality.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/mesh_check.h"
#include "core/mesh/subdivide.h"
#include "core/shapes/shapes.h"

namespace geolloyd {
namespace {

MeshQuality quality_of(const Mesh& mesh) {
  return measure_quality(mesh, find_edges(mesh));
}

Mesh one_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {{a, b, c}, {{0, 1, 2}}};
}

Mesh right_triangle(double width, double height) {
  return one_triangle({0, 0, 0}, {width, 0, 0}, {0, height, 0});
}

Mesh equilateral(double side) {
  return one_triangle({0, 0, 0}, {side, 0, 0}, {side / 2, 0, side * std::sqrt(3.0) / 2});
}

double angle_of(const Mesh& mesh) {
  return smallest_angle(corners_of(mesh, mesh.triangles[0]));
}

double q_of(const Mesh& mesh) {
  return triangle_quality(corners_of(mesh, mesh.triangles[0]));
}

double degrees(double radians) {
  return radians * 180 / 3.141592653589793;
}

TEST(TriangleQuality, IsOneOfAnEquilateralTriangleOfAnySize) {
  for (const double side : {1e-70, 0.1, 1.0, 1e70}) {
    EXPECT_NEAR(angle_of(equilateral(side)), 60, 1e-12);
    EXPECT_NEAR(q_of(equilateral(side)), 1, 1e-12);
  }
}

TEST(TriangleQuality, IsKnownOfRightTriangles) {
  // Area 1/2, half perimeter 1 + 1 / sqrt 2, longest edge sqrt 2.
  EXPECT_NEAR(angle_of(right_triangle(1, 1)), 45, 1e-12);
  EXPECT_NEAR(q_of(right_triangle(1, 1)), std::sqrt(3.0) / (1 + std::sqrt(2.0)), 1e-12);
  // Area 6, half perimeter 6, longest edge 5.
  EXPECT_NEAR(angle_of(right_triangle(3, 4)), degrees(std::atan(0.75)), 1e-12);
  EXPECT_NEAR(q_of(right_triangle(3, 4)), 6 / std::sqrt(3.0) / 5, 1e-12);
}

TEST(TriangleQuality, TellsNeedlesApart) {
  EXPECT_NEAR(angle_of(right_triangle(1, 1e-10)), degrees(1e-10), 1e-20);
  EXPECT_NEAR(q_of(right_triangle(1, 1e-10)), 3 / std::sqrt(3.0) * 1e-10, 1e-18);
}

// Corners turned and the triangle turned over change nothing.
TEST(TriangleQuality, IsTheSameFromEachCorner) {
  Mesh mesh = right_triangle(3, 4);
  for (const Triangle& t : {Triangle{1, 2, 0}, Triangle{2, 0, 1}, Triangle{2, 1, 0}}) {
    mesh.triangles[0] = t;
    EXPECT_NEAR(angle_of(mesh), degrees(std::atan(0.75)), 1e-12);
    EXPECT_NEAR(q_of(mesh), 6 / std::sqrt(3.0) / 5, 1e-12);
  }
}

TEST(TriangleQuality, IsZeroOfDegenerateTriangles) {
  const Vec3 o(0, 0, 0);
  const Vec3 x(1, 0, 0);
  for (const Mesh& mesh : {one_triangle(o, x, 3 * x), one_triangle(o, x, x), one_triangle(x, o, x),
                           one_triangle(x, x, x)}) {
    EXPECT_EQ(angle_of(mesh), 0);
    EXPECT_EQ(q_of(mesh), 0);
  }
  Mesh repeated = right_triangle(1, 1);
  repeated.triangles[0] = {0, 1, 0};
  EXPECT_EQ(angle_of(repeated), 0);
  EXPECT_EQ(q_of(repeated), 0);
}

TEST(MeshQuality, MeansAndSharesAreThoseOfItsTriangles) {
  Mesh mesh = equilateral(1);
  mesh.positions.insert(mesh.positions.end(), {{0, 0, 0}, {1, 0, 0}, {0, 1e-3, 0}});
  mesh.triangles.push_back({3, 4, 5});  // a needle
  mesh.triangles.push_back({3, 4, 3});
  mesh.triangles.push_back({0, 1, 2});  // the first one again
  const MeshQuality quality = quality_of(mesh);
  EXPECT_EQ(quality.smallest_angle, 0);
  EXPECT_EQ(quality.smallest_quality, 0);
  EXPECT_EQ(quality.share_under_30, 0.5);
  EXPECT_NEAR(quality.mean_smallest_angle, (120 + degrees(std::atan(1e-3))) / 4, 1e-12);
  EXPECT_NEAR(quality.mean_quality, (2 + triangle_quality(corners_of(mesh, mesh.triangles[1]))) / 4,
              1e-12);
}

TEST(MeshQuality, ThirtyDegreesAreNotUnderThirty) {
  const Mesh mesh = right_triangle(std::sqrt(3.0), 1 + 1e-12);
  EXPECT_EQ(quality_of(mesh).share_under_30, 0);
  EXPECT_EQ(quality_of(right_triangle(std::sqrt(3.0), 1 - 1e-12)).share_under_30, 1);
}

TEST(MeshQuality, RightAnglesAreNotObtuse) {
  Mesh mesh = right_triangle(1, 0.1);
  for (Vec3& p : mesh.positions) p += Vec3(1.0 / 3, 0.1, 1e3 / 7);
  EXPECT_EQ(quality_of(mesh).share_obtuse, 0);
  for (const double turn : {-1e-3, 1e-3}) {
    const Mesh turned{{{0, 0, 0}, {1, 0, 0}, {turn, 1, 0}}, {{0, 1, 2}}};
    EXPECT_EQ(quality_of(turned).share_obtuse, turn < 0 ? 1 : 0);
  }
}

TEST(MeshQuality, OfAnIcosahedronIsThatOfEquilateralTriangles) {
  const MeshQuality quality = quality_of(icosphere(20));
  EXPECT_NEAR(quality.smallest_angle, 60, 1e-5);
  EXPECT_NEAR(quality.mean_quality, 1, 1e-6);
  EXPECT_EQ(quality.inner_vertices, 12U);
  EXPECT_EQ(quality.share_valence_6, 0);
  EXPECT_EQ(quality.share_valence_5_to_7, 1);
}

// All but the icosahedron's twelve corners have six neighbours.
TEST(MeshQuality, KnowsTheValencesOfAnIcosphere) {
  const Mesh mesh = icosphere(2'000);
  const auto vertices = static_cast<double>(mesh.vertex_count());
  const MeshQuality quality = quality_of(mesh);
  EXPECT_EQ(quality.inner_vertices, mesh.vertex_count());
  EXPECT_DOUBLE_EQ(quality.share_valence_6, (vertices - 12) / vertices);
  EXPECT_EQ(quality.share_valence_5_to_7, 1);
}

TEST(MeshQuality, CountsTheInnerVerticesOfAPlaneOnly) {
  const Mesh square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const MeshQuality quality = quality_of(refine(square, 10));
  EXPECT_EQ(quality.inner_vertices, 81U);
  EXPECT_EQ(quality.share_valence_6, 1);
  EXPECT_NEAR(quality.smallest_angle, 45, 1e-9);
  EXPECT_NEAR(quality.mean_smallest_angle, 45, 1e-9);
  EXPECT_NEAR(quality.mean_quality, std::sqrt(3.0) / (1 + std::sqrt(2.0)), 1e-9);
}

// Corners become vertices of valence 4 and 8, centres of triangles have 6 and midpoints 4.
TEST(MeshQuality, SeesOtherValencesThanSix) {
  const MeshQuality quality = quality_of(subdivide_barycentric(icosphere(20)));
  EXPECT_EQ(quality.inner_vertices, 62U);
  EXPECT_DOUBLE_EQ(quality.share_valence_6, 20.0 / 62);
  EXPECT_DOUBLE_EQ(quality.share_valence_5_to_7, 20.0 / 62);
}

TEST(MeshQuality, LeavesOutTheVerticesOfEdgesThatAreNotManifold) {
  Mesh mesh = icosphere(20);
  mesh.positions.emplace_back(0, 0, 3);
  mesh.triangles.push_back({0, 11, 12});
  EXPECT_EQ(quality_of(mesh).inner_vertices, 10U);
}

TEST(MeshQuality, OfNothingIsNoNumber) {
  for (const Mesh& mesh : {Mesh{}, Mesh{{{0, 0, 0}}, {}}}) {
    const MeshQuality quality = quality_of(mesh);
    EXPECT_TRUE(std::isnan(quality.smallest_angle));
    EXPECT_TRUE(std::isnan(quality.mean_quality));
    EXPECT_TRUE(std::isnan(quality.share_valence_6));
    EXPECT_EQ(quality.inner_vertices, 0U);
  }
  EXPECT_TRUE(std::isnan(quality_of(equilateral(1)).share_valence_6));
}

TEST(MeshQuality, StandsBesideTheTopologyOfTheCheck) {
  const Mesh mesh = torus(2'000, 1);
  const MeshEdges edges = find_edges(mesh);
  EXPECT_EQ(check_mesh(mesh, edges).euler_characteristic, 0);
  EXPECT_EQ(measure_quality(mesh, edges).inner_vertices, mesh.vertex_count());
}

// Two triangles at the edge from (0, 0, 0) to (1, 0, 0), the second turned away from lying flat.
Mesh hinge(double turn_in_degrees) {
  const double turn = turn_in_degrees / degrees(1);
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -std::cos(turn), std::sin(turn)}},
          {{0, 1, 2}, {1, 0, 3}}};
}

TEST(Folds, AreEdgesTurnedByMoreThan150Degrees) {
  const auto folds_of = [](const Mesh& mesh) { return count_folds(mesh, find_edges(mesh)); };
  for (const double turn : {0.0, 90.0, 149.0}) EXPECT_EQ(folds_of(hinge(turn)), 0U) << turn;
  for (const double turn : {151.0, 180.0, -151.0}) EXPECT_EQ(folds_of(hinge(turn)), 1U) << turn;
  Mesh turned = hinge(151);
  std::swap(turned.triangles[1][0], turned.triangles[1][1]);  // whatever the orientation
  EXPECT_EQ(folds_of(turned), 1U);
  EXPECT_EQ(folds_of(torus(1000, 1)), 0U);
}

TEST(Folds, NeedTrianglesWithArea) {
  Mesh flat = hinge(180);
  flat.positions[3] = {0.5, 0, 0};
  EXPECT_EQ(count_folds(flat, find_edges(flat)), 0U);
  EXPECT_EQ(count_flat(flat), 1U);
  flat.positions[3] = {0.5, -1e-7, 0};
  EXPECT_EQ(count_flat(flat), 1U);
  flat.positions[3] = {0.5, -1e-5, 0};
  EXPECT_EQ(count_flat(flat), 0U);
  flat.triangles.push_back({1, 1, 2});
  EXPECT_EQ(count_flat(flat), 1U);
}

}  // namespace
}  // namespace geolloyd
