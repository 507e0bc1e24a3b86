#include "core/surface/cells/moments.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <vector>

#include "tests/support/brute_cells.h"
#include "tests/support/surface.h"

namespace geolloyd {
namespace {

struct Piece {
  std::vector<Vec3> corners;
  PieceMoments moments;
};

// Triangles of many sizes within the unit frame.
std::vector<Piece> random_pieces(std::uint64_t random_seed, std::size_t count) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < count; ++i) {
    const double size = std::ldexp(0.25, -static_cast<int>(i % 20));
    const Vec3 middle = random_point(random_seed, 4 * i, 0.5);
    std::vector<Vec3> corners;
    for (std::size_t c = 1; c <= 3; ++c) {
      corners.emplace_back(middle + random_point(random_seed, 4 * i + c, size));
    }
    const double area = norm(cross(corners[1] - corners[0], corners[2] - corners[0])) / 2;
    pieces.push_back({corners, moments_of_triangle(corners[0], corners[1], corners[2], area)});
  }
  return pieces;
}

double area_of(const std::vector<Piece>& pieces) {
  double area = 0;
  for (const Piece& piece : pieces) area += piece.moments.area;
  return area;
}

TEST(Moments, AreTheIntegralsOfATriangle) {
  for (const Piece& piece : random_pieces(1, 200)) {
    const PieceMoments expected = brute::moments_of_polygon(piece.corners);
    EXPECT_NEAR(piece.moments.area, expected.area, 1e-14 * expected.area);
    EXPECT_LE(norm(piece.moments.first - expected.first), 1e-14 * expected.area);
    EXPECT_NEAR(piece.moments.second, expected.second, 1e-14 * expected.area);
  }
}

TEST(Moments, SumToTheSameBitsInAnyOrder) {
  const std::vector<Piece> pieces = random_pieces(2, 1000);
  const MomentUnit unit(area_of(pieces));
  Moments forward;
  for (const Piece& piece : pieces) forward += unit.round(piece.moments);
  Moments backward;
  for (std::size_t i = pieces.size(); i-- > 0;) backward += unit.round(pieces[i].moments);
  EXPECT_EQ(forward, backward);
  // 7 has no divisor in common with 1000. Each is added, taken away and added again.
  Moments mixed;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    mixed += unit.round(pieces[7 * i % pieces.size()].moments);
    mixed -= unit.round(pieces[i].moments);
  }
  EXPECT_EQ(mixed, Moments{});
  for (const Piece& piece : pieces) mixed += unit.round(piece.moments);
  EXPECT_EQ(mixed, forward);
}

TEST(Moments, AreRoundedByLessThanAUnit) {
  const std::vector<Piece> pieces = random_pieces(3, 1000);
  const MomentUnit unit(area_of(pieces));
  for (const Piece& piece : pieces) {
    const Moments m = unit.round(piece.moments);
    EXPECT_LT(std::abs(static_cast<double>(m.area) - piece.moments.area * unit.per_unit), 1);
    for (int i = 0; i < 3; ++i) {
      EXPECT_LT(std::abs(static_cast<double>(m.first[i]) - piece.moments.first[i] * unit.per_unit),
                1);
    }
    EXPECT_LT(std::abs(static_cast<double>(m.second) - piece.moments.second * unit.per_unit), 1);
  }
}

TEST(Moments, HaveAUnitThatSuitsTheSurface) {
  for (double area = 1e-40; area < 1e12; area *= 3.7) {
    const MomentUnit unit(area);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(unit.per_unit) << 12, 0U) << "no power of two: " << area;
    // |x|^2 is at most 3.
    EXPECT_LT(3 * area * unit.per_unit, 0x1p62) << area;
    EXPECT_GT(area * unit.per_unit, 0x1p58) << "too coarse: " << area;
  }
  EXPECT_EQ(MomentUnit(0).per_unit, 1);
  EXPECT_EQ(MomentUnit().per_unit, 1);
}

// The corners of the unit frame's cube are farthest from its middle.
TEST(Moments, OfTheFarthestSurfaceFit) {
  const PieceMoments far{24, Vec3::Constant(-24), 72};
  const MomentUnit unit(far.area);
  const Moments m = unit.round(far);
  EXPECT_EQ(unit.area(m), 24);
  EXPECT_EQ(m.second, 3 * m.area);
  EXPECT_EQ(unit.centroid(m), Vec3(-1, -1, -1));
  EXPECT_EQ(unit.energy(m, Vec3(-1, -1, -1)), 0);
  EXPECT_EQ(unit.energy(m, Vec3(1, -1, -1)), 96);
}

TEST(Moments, GiveAreaCentroidAndEnergy) {
  const std::vector<Piece> pieces = random_pieces(4, 300);
  const MomentUnit unit(area_of(pieces));
  Moments sum;
  for (const Piece& piece : pieces) sum += unit.round(piece.moments);
  for (std::uint64_t n = 0; n < 10; ++n) {
    const Vec3 site = random_point(5, n);
    double area = 0;
    double energy = 0;
    Vec3 first = Vec3::Zero();
    for (const Piece& piece : pieces) {
      // in coordinates about the site
      std::vector<Vec3> corners;
      for (const Vec3& corner : piece.corners) corners.emplace_back(corner - site);
      const PieceMoments about = brute::moments_of_polygon(corners);
      area += about.area;
      first += about.first;
      energy += about.second;
    }
    EXPECT_NEAR(unit.area(sum), area, 1e-13 * area);
    EXPECT_LE(norm(unit.centroid(sum) - (first / area + site)), 1e-13);
    EXPECT_NEAR(unit.energy(sum, site), energy, 1e-13 * area);
  }
}

}  // namespace
}  // namespace geolloyd
