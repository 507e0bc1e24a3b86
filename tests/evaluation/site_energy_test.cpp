#include "tools/evaluation/site_energy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/base/random.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_measure.h"
#include "core/mesh/subdivide.h"
#include "core/shapes/shapes.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {
namespace {

double energy_of(const Mesh& mesh, const std::vector<Vec3>& sites) {
  return site_energy(mesh, find_edges(mesh).duplicates, sites);
}

void expect_same(double found, double expected, double relative) {
  EXPECT_NEAR(found / expected, 1, relative);
}

std::vector<Vec3> random_vertices(const Mesh& mesh, std::size_t count) {
  std::vector<Vec3> sites;
  for (std::uint64_t i = 0; i < count; ++i) {
    sites.push_back(
        mesh.positions[static_cast<std::size_t>(random_below(1, i, mesh.vertex_count()))]);
  }
  return sites;
}

// In the cube about the origin that has the side 2 * half.
std::vector<Vec3> random_sites(std::size_t count, double half) {
  std::vector<Vec3> sites;
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto coordinate = [&](std::uint64_t axis) {
      return half * (2 * random_unit(2, 3 * i + axis) - 1);
    };
    sites.emplace_back(coordinate(0), coordinate(1), coordinate(2));
  }
  return sites;
}

Mesh unit_square() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

Mesh moved(Mesh mesh, double scale, const Vec3& shift) {
  for (Vec3& p : mesh.positions) p = scale * p + shift;
  return mesh;
}

std::vector<Vec3> moved(std::vector<Vec3> sites, double scale, const Vec3& shift) {
  for (Vec3& p : sites) p = scale * p + shift;
  return sites;
}

double least_square(const std::vector<Vec3>& sites, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& s : sites) least = std::min(least, dot(p - s, p - s));
  return least;
}

// Of the barycentres of small triangles, with their areas.
double energy_by_samples(const Mesh& mesh, const std::vector<Vec3>& sites) {
  const Mesh fine = refine(mesh, 80);
  double energy = 0;
  for (TriangleId t = 0; t < fine.triangle_count(); ++t) {
    energy += triangle_area(fine, fine.triangles[t]) * least_square(sites, barycentre(fine, t));
  }
  return energy;
}

TEST(SiteEnergy, IsThatOfFineSampling) {
  const Mesh sphere = icosphere(80);
  for (const double half : {0.2, 1.0, 3.0}) {
    const std::vector<Vec3> sites = random_sites(40, half);
    expect_same(energy_of(sphere, sites), energy_by_samples(sphere, sites), 2e-4);
  }
  const Mesh square = unit_square();
  const std::vector<Vec3> sites = random_sites(30, 1);
  expect_same(energy_of(square, sites), energy_by_samples(square, sites), 2e-4);
}

TEST(SiteEnergy, OfASquaresMiddleIsItsSecondMoment) {
  const std::vector<Vec3> middle = {{0.5, 0.5, 0}};
  const std::vector<Vec3> above = {{0.5, 0.5, 3}};
  const std::vector<Vec3> quarters = {
      {0.25, 0.25, 0}, {0.75, 0.25, 0}, {0.25, 0.75, 0}, {0.75, 0.75, 0}};
  for (const Mesh& square : {unit_square(), irregular_plane(20'000, 1)}) {
    expect_same(energy_of(square, middle), 1.0 / 6, 1e-12);
    expect_same(energy_of(square, above), 1.0 / 6 + 9, 1e-12);
    expect_same(energy_of(square, quarters), 1.0 / 24, 1e-12);
  }
}

// A lattice of regular hexagons' centres, and a rhombus that lies among them and has the area of
// `side`^2 of them. The rhombus is that of the lattice, moved: it has as much of each place of a
// hexagon.
struct Hexagons {
  std::vector<Vec3> sites;
  Mesh rhombus;
  double energy;

  explicit Hexagons(int side) {
    const Vec3 u(1, 0, 0);
    const Vec3 v(0.5, std::sqrt(0.75), 0);
    for (int i = -3; i <= side + 3; ++i) {
      for (int j = -3; j <= side + 3; ++j) sites.emplace_back(i * u + j * v);
    }
    const Vec3 a(0.123, 0.456, 0);
    rhombus = {{a, a + side * u, a + side * u + side * v, a + side * v}, {{0, 1, 2}, {0, 2, 3}}};
    const double area = std::sqrt(0.75);
    energy = 5 / (18 * std::sqrt(3)) * area * area * side * side;
  }
};

TEST(SiteEnergy, OfALatticeOfHexagonsIsTheirs) {
  const Hexagons hexagons(20);
  for (const std::uint32_t frequency : {1U, 3U, 20U, 28U, 100U}) {
    SCOPED_TRACE(frequency);
    expect_same(energy_of(refine(hexagons.rhombus, frequency), hexagons.sites), hexagons.energy,
                1e-12);
  }
}

// Whether a site has a tenth of a vertex, two vertices or tens.
TEST(SiteEnergy, IsTheSameOnASubdividedMesh) {
  for (const Mesh& mesh : {torus(600, 1), creature(1'000, 1), irregular_plane(600, 1)}) {
    const Mesh finer = refine(mesh, 5);
    for (const std::vector<Vec3>& sites :
         {random_vertices(finer, 10 * mesh.vertex_count()),
          random_vertices(mesh, mesh.vertex_count() / 2), random_sites(20, 1)}) {
      SCOPED_TRACE(sites.size());
      const double energy = energy_of(mesh, sites);
      EXPECT_GT(energy, 0);
      expect_same(energy_of(finer, sites), energy, 1e-12);
      expect_same(energy_of(subdivide_barycentric(mesh), sites), energy, 1e-12);
    }
  }
}

TEST(SiteEnergy, OfTwoTrianglesWithThousandsOfSitesIsThatOfManyTriangles) {
  const std::vector<Vec3> sites = random_vertices(irregular_plane(50'000, 2), 5'000);
  expect_same(energy_of(unit_square(), sites), energy_of(irregular_plane(20'000, 1), sites), 1e-12);
}

// Most corners are as far from two, four or eight sites.
TEST(SiteEnergy, OfALatticeWithVerticesOnItsBordersIsThatOfSquares) {
  std::vector<Vec3> sites;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      sites.insert(sites.end(), 2, Vec3((x + 0.5) / 8, (y + 0.5) / 8, 0.25));
      sites.emplace_back((x + 0.5) / 8, (y + 0.5) / 8, -0.25);
    }
  }
  for (const std::uint32_t frequency : {1U, 2U, 8U, 12U, 24U}) {
    expect_same(energy_of(refine(unit_square(), frequency), sites), 1.0 / 6 / 64 + 1.0 / 16, 1e-12);
  }
}

// Sites apart by less than, about as much as, and more than rounding.
TEST(SiteEnergy, OfSitesThatAreAllButEqualIsThatOfOne) {
  const Mesh square = moved(irregular_plane(200, 1), 1, {1e3, 1e3, 1e3});
  const std::vector<Vec3> middle = {{1e3 + 0.5, 1e3 + 0.5, 1e3}};
  for (const double apart : {0.0, 1e-16, 1e-13, 1e-12, 1e-10}) {
    SCOPED_TRACE(apart);
    expect_same(energy_of(square, moved(random_sites(200, 1), apart, middle[0])), 1.0 / 6, 1e-9);
  }
}

TEST(SiteEnergy, ScalesWithTheFourthPowerAndDoesNotDependOnThePlace) {
  const Mesh mesh = torus(2'000, 1);
  const std::vector<Vec3> sites = random_vertices(mesh, 300);
  const double energy = energy_of(mesh, sites);
  const Vec3 none = Vec3::Zero();
  for (const int exponent : {-200, -3, 1, 200}) {
    const double scale = std::ldexp(1, exponent);
    EXPECT_EQ(energy_of(moved(mesh, scale, none), moved(sites, scale, none)),
              std::ldexp(energy, 4 * exponent));
  }
  for (const double scale : {1e-50, 0.3, 1e50}) {
    expect_same(energy_of(moved(mesh, scale, none), moved(sites, scale, none)),
                energy * scale * scale * scale * scale, 1e-12);
  }
  for (const double far : {10.0, 1e4, 1e8}) {
    const Vec3 shift(far, -far, far);
    expect_same(energy_of(moved(mesh, 1, shift), moved(sites, 1, shift)), energy,
                1e-12 + 1e-14 * far);
  }
}

TEST(SiteEnergy, CountsWhatIsTwiceOnceAndWhatHasNoAreaNot) {
  const std::vector<Vec3> sites = random_sites(20, 1);
  Mesh mesh = unit_square();
  const double energy = energy_of(mesh, sites);
  mesh.positions.emplace_back(1e75, 0, 0);  // belongs to no triangle
  mesh.triangles.insert(mesh.triangles.end(),
                        {{2, 0, 1}, {0, 3, 2}, {0, 0, 1}, {3, 3, 3}, {0, 1, 2}});
  EXPECT_EQ(energy_of(mesh, sites), energy);
}

TEST(SiteEnergy, IsTheSameForAnyNumberOfThreads) {
  const Mesh mesh = creature(30'000, 1);
  const std::vector<Vec3> sites = random_vertices(mesh, 3'000);
  const double energy = energy_of(mesh, sites);
  for (const std::size_t threads : {1U, 2U, 3U, 8U}) {
    Scheduler scheduler(threads);
    EXPECT_EQ(site_energy(mesh, {}, sites, scheduler), energy);
  }
}

}  // namespace
}  // namespace geolloyd
