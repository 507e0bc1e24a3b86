#include "tools/evaluation/distances/point_queries.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <memory>
#include <vector>

#include "core/base/random.h"
#include "core/mesh/closest_on_triangle.h"
#include "core/shapes/shapes.h"
#include "geolloyd/errors.h"
#include "tools/evaluation/distances/unit_frame.h"
#include "tools/render/ray_caster.h"

namespace geolloyd {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// In the cube from -half to half.
Vec3 random_point(std::uint64_t random_seed, std::uint64_t n, double half = 1) {
  const auto coordinate = [&](std::uint64_t axis) {
    return half * (2 * random_unit(random_seed, 3 * n + axis) - 1);
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

std::vector<Vec3> random_points(std::uint64_t random_seed, std::size_t count, double half = 1) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(random_point(random_seed, i, half));
  return points;
}

std::uint32_t nearest_by_force(const std::vector<Vec3>& sites, const Vec3& p) {
  std::uint32_t nearest = 0;
  double least = infinity;
  for (std::uint32_t i = 0; i < sites.size(); ++i) {
    const Vec3 away = p - sites[i];
    const double square = dot(away, away);
    if (square < least) {
      least = square;
      nearest = i;
    }
  }
  return nearest;
}

// Asks for points inside the box of the sites, around it, and so far away that they are all alike;
// for the sites themselves, and for the points midway between two, with whatever guess.
void expect_nearest_as_by_force(const std::vector<Vec3>& sites, double half) {
  const NearestSite nearest(sites, 2);
  std::vector<Vec3> asked = sites;
  for (const double far : {1.0, 10.0, 1e4, 1e7, 1e12, 1e20, 1e44}) {
    for (const Vec3& p : random_points(9, 100, far)) asked.emplace_back(p * half);
  }
  for (std::size_t i = 0; i < 200; ++i) {
    const Vec3& a = sites[random_bits(7, i) % sites.size()];
    const Vec3& b = sites[random_bits(8, i) % sites.size()];
    asked.emplace_back((a + b) / 2);
  }
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const auto guess = static_cast<std::uint32_t>(random_bits(5, i) % sites.size());
    const std::uint32_t expected = nearest_by_force(sites, asked[i]);
    ASSERT_EQ(nearest.find(asked[i]), expected) << asked[i].transpose();
    ASSERT_EQ(nearest.find(asked[i], guess), expected) << asked[i].transpose();
  }
}

TEST(NearestSite, IsThatOfBruteForceAtAllMagnitudes) {
  for (const double half : {1.0, 1e30, 1e-30, 1e-150, 1e-170, 1e-308, 1e-310}) {
    SCOPED_TRACE(half);
    expect_nearest_as_by_force(random_points(1, 300, half), half);
  }
}

TEST(NearestSite, TakesTheSmallerIndexOfEquals) {
  std::vector<Vec3> lattice;  // where most midpoints are as far from several
  for (int z = 0; z < 6; ++z) {
    for (int y = 0; y < 6; ++y) {
      for (int x = 0; x < 6; ++x) lattice.emplace_back(x, y, z);
    }
  }
  expect_nearest_as_by_force(lattice, 6);
  std::vector<Vec3> twice = random_points(2, 50);
  twice.insert(twice.end(), twice.rbegin(), twice.rend());
  expect_nearest_as_by_force(twice, 1);
  expect_nearest_as_by_force(std::vector<Vec3>(40, Vec3(1, 2, 3)), 1);
}

TEST(NearestSite, FindsOneSiteAndSitesThatAreAllButEqual) {
  expect_nearest_as_by_force({Vec3(1e30, -1e30, 5)}, 1e30);
  std::vector<Vec3> line;
  line.reserve(100);
  for (int i = 0; i < 100; ++i) line.emplace_back(1e9 + i * 1e-3, 0, 0);
  expect_nearest_as_by_force(line, 1);
  std::vector<Vec3> dense = random_points(3, 200, 1e-9);
  dense.emplace_back(1, 1, 1);  // so that 24 bits do not tell the others apart
  expect_nearest_as_by_force(dense, 1e-9);
}

// Brute force over the triangles; the point on each is tested below.
FoundPoint closest_by_force(const Mesh& mesh, const Vec3& p) {
  const double scale = UnitFrame(mesh.positions).scale;
  FoundPoint closest{no_id, p, infinity};
  double least = infinity;
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    std::array<Vec3, 3> corner;
    for (std::size_t i = 0; i < 3; ++i) corner[i] = mesh.positions[mesh.triangles[t][i]];
    const auto& [a, b, c] = corner;
    const auto [v, w] =
        barycentric_closest_to_origin({(a - p) * scale, (b - p) * scale, (c - p) * scale});
    const Vec3 position = a + v * (b - a) + w * (c - a);
    const Vec3 away = (p - position) * scale;
    const double square = dot(away, away);
    if (square < least) {
      least = square;
      closest = {t, position, std::sqrt(square) / scale};
    }
  }
  return closest;
}

void expect_closest_as_by_force(const Mesh& mesh, const std::vector<Vec3>& asked) {
  const ClosestPoint surface(mesh, 2);
  for (const Vec3& p : asked) {
    const FoundPoint expected = closest_by_force(mesh, p);
    const FoundPoint found = surface.find(p);
    ASSERT_EQ(found.triangle, expected.triangle) << p.transpose();
    ASSERT_EQ(found.position, expected.position) << p.transpose();
    ASSERT_EQ(found.distance, expected.distance) << p.transpose();
    for (const TriangleId guess : {TriangleId{0}, expected.triangle}) {
      ASSERT_EQ(surface.find(p, guess).triangle, expected.triangle) << p.transpose();
      ASSERT_GE(surface.distance_to(p, guess), expected.distance) << p.transpose();
    }
    ASSERT_EQ(surface.distance_to(p, expected.triangle), expected.distance) << p.transpose();
    if (expected.distance > 0) {
      ASSERT_EQ(surface.find_within(p, std::nextafter(expected.distance, 0.0)), no_id);
    }
    const TriangleId near = surface.find_within(p, expected.distance);
    ASSERT_NE(near, no_id) << p.transpose();
    ASSERT_EQ(surface.distance_to(p, near), expected.distance) << p.transpose();
  }
}

// Triangles at random, some of them long and thin, segments and points.
Mesh random_soup(std::uint64_t random_seed, std::size_t triangles, double half) {
  Mesh mesh;
  for (std::size_t t = 0; t < triangles; ++t) {
    const Vec3 a = random_point(random_seed, 3 * t, half);
    const Vec3 b = a + random_point(random_seed, 3 * t + 1, half / 5);
    const Vec3 aside = random_point(random_seed, 3 * t + 2, half / 5);
    const Vec3 c = t % 5 == 0   ? Vec3(a + 0.3 * (b - a))
                   : t % 5 == 1 ? Vec3(b + 1e-12 * aside)
                                : Vec3(a + aside);
    mesh.positions.insert(mesh.positions.end(), {a, t % 7 == 0 ? a : b, t % 21 == 0 ? a : c});
    const auto v = static_cast<VertexId>(3 * t);
    mesh.triangles.push_back(t % 11 == 0 ? Triangle{v, v, v + 2} : Triangle{v, v + 1, v + 2});
  }
  return mesh;
}

TEST(ClosestPoint, IsThatOfBruteForceOnSoups) {
  for (const double half : {1.0, 1e30, 1e-30}) {
    SCOPED_TRACE(half);
    const Mesh soup = random_soup(1, 400, half);
    std::vector<Vec3> asked = random_points(2, 300, 2 * half);
    const std::vector<Vec3> far = random_points(3, 50, 1e5 * half);
    asked.insert(asked.end(), far.begin(), far.end());
    asked.insert(asked.end(), soup.positions.begin(), soup.positions.end());
    expect_closest_as_by_force(soup, asked);
  }
}

TEST(ClosestPoint, IsThatOfBruteForceOnShapes) {
  for (const Mesh& mesh : {torus(1000, 3), creature(1500, 4), irregular_plane(800, 5)}) {
    expect_closest_as_by_force(mesh, random_points(6, 300, 1.5));
  }
}

TEST(ClosestPoint, OfAVertexIsTheVertexAndTheSmallestTriangleThatHasIt) {
  const Mesh mesh = icosphere(500);
  const ClosestPoint surface(mesh, 2);
  std::vector<TriangleId> first(mesh.vertex_count(), no_id);
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    for (const VertexId v : mesh.triangles[t]) first[v] = std::min(first[v], t);
  }
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    const FoundPoint found = surface.find(mesh.positions[v]);
    EXPECT_EQ(found.triangle, first[v]);
    EXPECT_LT(found.distance, 1e-15);
  }
}

// Against the definition: no point of the triangle is closer than the one found.
TEST(ClosestPoint, OnOneTriangleIsClosestOfAll) {
  const Mesh soup = random_soup(8, 200, 1);
  for (std::uint32_t t = 0; t < soup.triangle_count(); ++t) {
    const auto& [i, j, k] = soup.triangles[t];
    const Vec3 p = random_point(9, t);
    const Vec3 a = soup.positions[i] - p;
    const Vec3 b = soup.positions[j] - p;
    const Vec3 c = soup.positions[k] - p;
    const auto [v, w] = barycentric_closest_to_origin({a, b, c});
    EXPECT_GE(std::min({v, w, 1 - v - w}), -1e-15);
    const double found = norm(a + v * (b - a) + w * (c - a));
    constexpr int steps = 40;
    for (int x = 0; x <= steps; ++x) {
      for (int y = 0; x + y <= steps; ++y) {
        EXPECT_LE(found, norm(a + (b - a) * x / steps + (c - a) * y / steps) + 1e-15);
      }
    }
  }
}

TEST(ClosestPoint, OnAPlaneIsTheFootOfThePerpendicular) {
  const Mesh plane = irregular_plane(5000, 1);
  const ClosestPoint surface(plane, 2);
  for (std::size_t i = 0; i < 500; ++i) {
    const Vec3 p = random_point(2, i, 2);
    const Vec3 foot(std::clamp(p.x(), 0.0, 1.0), std::clamp(p.y(), 0.0, 1.0), 0);
    const FoundPoint found = surface.find(p);
    EXPECT_LT(norm(found.position - foot), 1e-12);
    EXPECT_NEAR(found.distance, norm(p - foot), 1e-12);
  }
}

std::size_t threads_of_this_process() {
  const std::filesystem::directory_iterator threads("/proc/self/task");
  return static_cast<std::size_t>(std::distance(begin(threads), end(threads)));
}

// Embree starts as many as it is allowed, and they stay: a process of one of these tests alone has
// none. (oneTBB may start an idle one where a second device takes the place of a first.)
template <class MakeScene>
void expect_no_further_thread(MakeScene&& make_scene) {
  const Mesh mesh = icosphere(100'000);
  const std::size_t before = threads_of_this_process();
  const auto scene = make_scene(mesh);
  EXPECT_EQ(threads_of_this_process(), before);
}

TEST(EmbreeThreads, OfTheClosestPointAreAsManyAsAllowed) {
  expect_no_further_thread(
      [](const Mesh& mesh) { return std::make_unique<ClosestPoint>(mesh, 1); });
}

TEST(EmbreeThreads, OfTheNearestSiteAreAsManyAsAllowed) {
  expect_no_further_thread(
      [](const Mesh& mesh) { return std::make_unique<NearestSite>(mesh.positions, 1); });
}

TEST(EmbreeThreads, OfTheRayCasterAreAsManyAsAllowed) {
  expect_no_further_thread([](const Mesh& mesh) { return std::make_unique<RayCaster>(mesh, 1); });
}

TEST(ClosestPoint, NeedsASurface) {
  EXPECT_THROW(ClosestPoint(Mesh{}, 2), InvalidInput);
}

// Each search would visit them all.
TEST(NearestSite, IsTheFirstOfVeryManyInOnePlace) {
  std::vector<Vec3> sites = {{3, 0, 0}};
  sites.resize(100'000, Vec3(1, 2, 3));
  const NearestSite nearest(sites, 2);
  for (std::uint32_t i = 0; i < sites.size(); ++i) {
    ASSERT_EQ(nearest.find(random_point(1, i), i),
              nearest_by_force({sites[0], sites[1]}, random_point(1, i)));
  }
}

TEST(ClosestPoint, IsOnTheFirstOfVeryManyTrianglesInOnePlace) {
  Mesh mesh;
  mesh.positions = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  mesh.triangles.assign(100'000, {0, 1, 2});
  mesh.triangles[7] = {3, 4, 5};
  const ClosestPoint closest(mesh, 2);
  Mesh few = mesh;
  few.triangles.resize(8);
  const ClosestPoint closest_of_few(few, 1);
  for (std::uint32_t i = 0; i < mesh.triangle_count(); ++i) {
    const Vec3 p = random_point(2, i, 3);
    const FoundPoint found = closest.find(p, i);
    const FoundPoint expected = closest_of_few.find(p);
    ASSERT_EQ(found.triangle, expected.triangle);
    ASSERT_EQ(found.position, expected.position);
    ASSERT_NE(closest.find_within(p, found.distance), no_id);
  }
}

}  // namespace
}  // namespace geolloyd
