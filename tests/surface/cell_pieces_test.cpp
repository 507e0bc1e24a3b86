#include "core/surface/cells/cell_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "tests/support/brute_cells.h"
#include "tests/support/random_graph.h"
#include "tests/support/surface.h"

namespace geolloyd {
namespace {

// Triangle 0 has the corners 0, 1, 2; beyond the edges opposite to them are the vertices 3, 4, 5.
FineMesh with_neighbours(const Vec3& a, const Vec3& b, const Vec3& c) {
  FineMesh mesh;
  mesh.positions = {a, b, c, b + c - a, c + a - b, a + b - c};
  mesh.triangles = {{0, 1, 2}, {3, 2, 1}, {4, 0, 2}, {5, 1, 0}};
  connect(mesh);
  return mesh;
}

FineMesh random_triangle(std::uint64_t random_seed) {
  const Vec3 at = random_point(random_seed, 0, 0.5);
  const Vec3 ab = random_point(random_seed, 1, 0.3);
  const Vec3 ac = random_point(random_seed, 2, 0.3);
  return with_neighbours(at, at + ab, at + ac);
}

struct Share {
  RegionId site;
  Moments moments;
};

std::vector<Share> shares_of(const FineMesh& mesh, const std::vector<RegionId>& labels,
                             const std::vector<Vec3>& sites) {
  const MomentUnit unit(mesh.whole_area);
  const RegionId main = main_site(mesh, 0, labels);
  if (main == no_id) return {};
  std::vector<Share> shares = {{main, moments_of(mesh, unit, 0)}};
  for_each_piece(mesh, unit, 0, labels, sites, [&](RegionId r, const Moments& piece) {
    shares.push_back({r, piece});
    shares.front().moments -= piece;
  });
  return shares;
}

// The rule of cell_pieces.h: the labels of the corners and of the vertices beyond the edges.
std::vector<RegionId> candidates_of(const std::vector<RegionId>& labels) {
  if (labels[0] == labels[1] && labels[1] == labels[2]) return {labels[0]};
  std::vector<RegionId> found(labels.begin(), labels.begin() + 6);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

// Whatever the candidates: each has one share at most, none is negative, they sum to the triangle,
// and together they have the energy of the nearest candidate everywhere, whoever owns what is at
// equal distances.
void expect_sound(const FineMesh& mesh, const std::vector<RegionId>& labels,
                  const std::vector<Vec3>& sites) {
  const MomentUnit unit(mesh.whole_area);
  const std::vector<RegionId> candidates = candidates_of(labels);
  const std::vector<Vec3> triangle(mesh.positions.begin(), mesh.positions.begin() + 3);
  const auto pieces = brute::pieces_of(triangle, sites, candidates);
  double expected = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Vec3& site = sites[candidates[i]];
    const bool is_first =
        std::none_of(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(i),
                     [&](RegionId r) { return brute::are_equally_far(triangle, site, sites[r]); });
    if (is_first) expected += brute::energy(brute::moments_of_polygon(pieces[i]), site);
  }
  Moments sum;
  double energy = 0;
  std::vector<RegionId> seen;
  for (const auto& [site, moments] : shares_of(mesh, labels, sites)) {
    sum += moments;
    energy += unit.energy(moments, sites[site]);
    seen.push_back(site);
    EXPECT_GE(unit.area(moments), -1e-14 * mesh.area(0));
  }
  EXPECT_EQ(sum, moments_of(mesh, unit, 0));
  EXPECT_NEAR(energy, expected, 1e-13 * mesh.area(0) + 1e-17);
  std::sort(seen.begin(), seen.end());
  EXPECT_EQ(std::ranges::adjacent_find(seen), seen.end()) << "two shares";
  EXPECT_TRUE(std::ranges::includes(candidates, seen));
}

// No two sites at one place, so each piece is known.
void expect_exact(const FineMesh& mesh, const std::vector<RegionId>& labels,
                  const std::vector<Vec3>& sites) {
  expect_sound(mesh, labels, sites);
  const MomentUnit unit(mesh.whole_area);
  const std::vector<RegionId> candidates = candidates_of(labels);
  const std::vector<Vec3> triangle(mesh.positions.begin(), mesh.positions.begin() + 3);
  const auto pieces = brute::pieces_of(triangle, sites, candidates);
  for (const auto& [site, moments] : shares_of(mesh, labels, sites)) {
    const auto found = std::lower_bound(candidates.begin(), candidates.end(), site);
    const PieceMoments expected =
        brute::moments_of_polygon(pieces[static_cast<std::size_t>(found - candidates.begin())]);
    const double tolerance = 1e-12 * mesh.area(0);
    EXPECT_NEAR(unit.area(moments), expected.area, tolerance);
    EXPECT_NEAR(unit.energy(moments, sites[site]), brute::energy(expected, sites[site]), tolerance);
    const Vec3 first =
        unit.area(moments) > 0 ? Vec3(unit.centroid(moments) * unit.area(moments)) : Vec3::Zero();
    EXPECT_LE(norm(first - expected.first), tolerance);
  }
}

// About the triangle, off its plane as well.
std::vector<Vec3> sites_about(const FineMesh& mesh, std::uint64_t random_seed, std::size_t count) {
  const Vec3 middle = (mesh.positions[0] + mesh.positions[1] + mesh.positions[2]) / 3;
  std::vector<Vec3> sites;
  for (std::size_t i = 0; i < count; ++i) {
    sites.emplace_back(middle + random_point(random_seed, 100 + i, 0.4));
  }
  return sites;
}

// `count` different ones at the six vertices, the corners not all the same.
std::vector<RegionId> random_labels(std::uint64_t random_seed, RegionId count) {
  for (std::uint64_t attempt = 0;; ++attempt) {
    std::vector<RegionId> labels;
    for (std::uint64_t i = 0; i < 6; ++i) {
      labels.push_back(random_number(random_seed, 6 * attempt + i, count));
    }
    if (candidates_of(labels).size() == count) return labels;
  }
}

// Corners have any labels, as those that are fixed may, so they may lie on any side of a bisector.
TEST(CellPieces, AreThoseOfAnyCandidates) {
  for (std::uint64_t n = 0; n < 3000; ++n) {
    SCOPED_TRACE(n);
    const auto count = static_cast<RegionId>(2 + n % 5);
    const FineMesh mesh = random_triangle(n);
    expect_exact(mesh, random_labels(n, count), sites_about(mesh, n, count));
  }
}

// As sweeps leave them: each vertex has the nearest of the sites.
TEST(CellPieces, AreThoseOfTheNearestSites) {
  std::array<int, 7> cut_by{};
  for (std::uint64_t n = 0; n < 3000; ++n) {
    SCOPED_TRACE(n);
    const FineMesh mesh = random_triangle(n);
    const std::vector<Vec3> sites = sites_about(mesh, n + 7, 8);
    std::vector<RegionId> labels;
    for (const Vec3& p : mesh.positions) {
      const auto nearest =
          std::min_element(sites.begin(), sites.end(),
                           [&](const Vec3& a, const Vec3& b) { return norm(a - p) < norm(b - p); });
      labels.push_back(static_cast<RegionId>(nearest - sites.begin()));
    }
    ++cut_by[candidates_of(labels).size()];
    expect_exact(mesh, labels, sites);
  }
  for (std::size_t count = 1; count <= 5; ++count) EXPECT_GT(cut_by[count], 20) << count;
}

// An independent look: points all over a triangle ask for the nearest candidate.
TEST(CellPieces, OwnThePointsThatAreNearest) {
  constexpr int rows = 200;
  for (std::uint64_t n = 0; n < 20; ++n) {
    const auto count = static_cast<RegionId>(2 + n % 5);
    const FineMesh mesh = random_triangle(n + 5000);
    const std::vector<Vec3> sites = sites_about(mesh, n, count);
    const std::vector<RegionId> labels = random_labels(n, count);
    std::vector<double> points(count, 0);
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < rows - i; ++j) {
        const Vec3 p = mesh.positions[0] +
                       (i + 1.0 / 3) / rows * (mesh.positions[1] - mesh.positions[0]) +
                       (j + 1.0 / 3) / rows * (mesh.positions[2] - mesh.positions[0]);
        RegionId nearest = 0;
        for (RegionId r = 1; r < count; ++r) {
          if (norm(sites[r] - p) < norm(sites[nearest] - p)) nearest = r;
        }
        ++points[nearest];
      }
    }
    const MomentUnit unit(mesh.whole_area);
    for (const auto& [site, moments] : shares_of(mesh, labels, sites)) {
      EXPECT_NEAR(unit.area(moments) / mesh.area(0), points[site] / (rows * (rows + 1) / 2.0),
                  4.0 / rows)
          << n << " site " << site;
    }
  }
}

TEST(CellPieces, OfCornersWithOneLabelAreTheWholeTriangle) {
  const FineMesh mesh = random_triangle(1);
  const std::vector<Vec3> sites = sites_about(mesh, 1, 4);
  const auto shares = shares_of(mesh, {2, 2, 2, 0, 1, 3}, sites);
  ASSERT_EQ(shares.size(), 1U);
  EXPECT_EQ(shares[0].site, 2U);
  EXPECT_EQ(shares[0].moments, moments_of(mesh, MomentUnit(mesh.whole_area), 0));
  EXPECT_TRUE(shares_of(mesh, std::vector<RegionId>(6, no_id), sites).empty());
}

// What has no label is no candidate, and those that have one share its part.
TEST(CellPieces, GoToTheSitesThatThereAre) {
  const FineMesh mesh = random_triangle(2);
  const std::vector<Vec3> sites = sites_about(mesh, 2, 3);
  const auto shares = shares_of(mesh, {no_id, 1, no_id, no_id, no_id, no_id}, sites);
  ASSERT_EQ(shares.size(), 1U);
  EXPECT_EQ(shares[0].site, 1U);
  EXPECT_EQ(shares[0].moments, moments_of(mesh, MomentUnit(mesh.whole_area), 0));
  Moments sum;
  for (const Share& share : shares_of(mesh, {0, 1, 2, no_id, no_id, no_id}, sites)) {
    sum += share.moments;
  }
  EXPECT_EQ(sum, moments_of(mesh, MomentUnit(mesh.whole_area), 0));
}

// A boundary triangle has nothing across.
TEST(CellPieces, OfATriangleAlone) {
  FineMesh mesh;
  mesh.positions = {{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}};
  mesh.triangles = {{0, 1, 2}};
  connect(mesh);
  const std::vector<Vec3> sites = {{0, 0, 0}, {0.5, 0, 0}};
  const MomentUnit unit(mesh.whole_area);
  for (const auto& [site, moments] : shares_of(mesh, {0, 1, 0}, sites)) {
    EXPECT_NEAR(unit.area(moments), site == 1 ? 0.03125 : 0.09375, 1e-15);
  }
}

// Sites mirrored in the edges and medians of the triangle, on a coarse grid: corners on bisectors,
// bisectors along edges, three bisectors in a point, the same site twice and more.
TEST(CellPieces, WithTies) {
  for (std::uint64_t n = 0; n < 5000; ++n) {
    SCOPED_TRACE(n);
    const auto count = static_cast<RegionId>(2 + n % 5);
    const auto on_grid = [&](std::uint64_t i) -> Vec3 {
      const Vec3 cell(random_number(n, 3 * i, 5), random_number(n, 3 * i + 1, 5),
                      random_number(n, 3 * i + 2, 2));
      return cell / 8;
    };
    const FineMesh mesh = with_neighbours(on_grid(0), on_grid(1), on_grid(2));
    std::vector<Vec3> sites;
    for (RegionId r = 0; r < count; ++r) sites.push_back(on_grid(10 + r));
    expect_sound(mesh, random_labels(n, count), sites);
  }
}

TEST(CellPieces, WithAllSitesAtOnePlace) {
  for (RegionId count = 2; count <= 6; ++count) {
    const FineMesh mesh = random_triangle(count);
    const std::vector<Vec3> sites(count, Vec3(0.1, 0.2, 0.3));
    for (std::uint64_t n = 0; n < 50; ++n) {
      const std::vector<RegionId> labels = random_labels(n, count);
      expect_sound(mesh, labels, sites);
      // One of them has all.
      const MomentUnit unit(mesh.whole_area);
      for (const Share& share : shares_of(mesh, labels, sites)) {
        EXPECT_TRUE(share.moments == Moments{} || share.moments == moments_of(mesh, unit, 0));
      }
    }
  }
}

// Where rounding decides on which side a vertex of a piece is, pieces get vertices that exact ones
// have not.
TEST(CellPieces, OfSitesThatAreNearlyEqual) {
  for (std::uint64_t n = 0; n < 20000; ++n) {
    const FineMesh mesh = random_triangle(n);
    const Vec3 place = random_point(n, 3);
    std::vector<Vec3> sites;
    for (std::uint64_t i = 4; i < 10; ++i) {
      sites.emplace_back(place + random_point(n, i, n % 2 == 0 ? 2e-16 : 1e-15));
    }
    const std::vector<RegionId> labels = {0, 1, 2, 3, 4, 5};
    const MomentUnit unit(mesh.whole_area);
    Moments sum;
    double energy = 0;
    for (const Share& share : shares_of(mesh, labels, sites)) {
      sum += share.moments;
      energy += unit.energy(share.moments, place);
    }
    EXPECT_EQ(sum, moments_of(mesh, unit, 0));
    EXPECT_NEAR(energy, unit.energy(sum, place), 1e-12 * mesh.area(0));
  }
}

// One such piece had nine vertices.
TEST(CellPieces, OfASliverOfManyCorners) {
  const FineMesh mesh =
      with_neighbours({0x1.613fc4e246e76p-1, -0x1.bc2d4a314122p-5, -0x1.b9365bb59c58p-7},
                      {-0x1.7b46db8ded7ecp-1, 0x1.889b683b5a52p-3, -0x1.b39d4ee48924cp-2},
                      {-0x1.495dd2d224186p-1, 0x1.61bc208e2fae2p-1, 0x1.5023e91d1c7b2p-1});
  const std::vector<Vec3> sites = {
      {-0x1.095519acfa65dp-1, 0x1.dfb10851ee0c2p-2, -0x1.ce115b179cca8p-3},
      {-0x1.095519acfa65cp-1, 0x1.dfb10851ee0c2p-2, -0x1.ce115b179cca8p-3},
      {-0x1.095519acfa65cp-1, 0x1.dfb10851ee0c1p-2, -0x1.ce115b179cca8p-3},
      {-0x1.095519acfa65cp-1, 0x1.dfb10851ee0cp-2, -0x1.ce115b179cca8p-3},
      {-0x1.095519acfa65dp-1, 0x1.dfb10851ee0c2p-2, -0x1.ce115b179cca8p-3},
      {-0x1.095519acfa65bp-1, 0x1.dfb10851ee0bdp-2, -0x1.ce115b179cca7p-3}};
  Moments sum;
  for (const Share& share : shares_of(mesh, {0, 1, 2, 3, 4, 5}, sites)) sum += share.moments;
  EXPECT_EQ(sum, moments_of(mesh, MomentUnit(mesh.whole_area), 0));
}

TEST(CellPieces, OfTrianglesWithoutArea) {
  const Vec3 p(0.25, 0.5, -0.125);
  const Vec3 along(0.25, 0, 0.5);
  for (const FineMesh& mesh : {with_neighbours(p, p, p), with_neighbours(p, p, p + along),
                               with_neighbours(p, p + along, p + along / 2)}) {
    for (RegionId count = 2; count <= 6; ++count) {
      for (std::uint64_t n = 0; n < 50; ++n) {
        for (const Share& share :
             shares_of(mesh, random_labels(n, count), sites_about(mesh, n, count))) {
          EXPECT_EQ(share.moments, Moments{});
        }
      }
    }
  }
}

// A thousand times longer than high, cut along and across.
TEST(CellPieces, OfNeedles) {
  for (std::uint64_t n = 0; n < 300; ++n) {
    SCOPED_TRACE(n);
    const auto count = static_cast<RegionId>(2 + n % 5);
    const Vec3 at = random_point(n, 0, 0.5);
    const Vec3 along = random_point(n, 1, 0.5);
    const FineMesh mesh =
        with_neighbours(at, at + along, at + along / 3 + random_point(n, 2, 0.0005));
    expect_exact(mesh, random_labels(n, count), sites_about(mesh, n, count));
  }
}

}  // namespace
}  // namespace geolloyd
