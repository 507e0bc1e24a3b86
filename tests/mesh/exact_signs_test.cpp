// Signs of determinants, against whole numbers of 128 bits.
#include "core/mesh/exact_signs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "core/base/random.h"

namespace geolloyd {
namespace {

__extension__ using Whole = __int128;
using Place = std::array<std::int64_t, 3>;

int sign_of(Whole x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

Whole area(const Place& a, const Place& b, const Place& c, std::size_t x, std::size_t y) {
  return Whole{a[x] - c[x]} * (b[y] - c[y]) - Whole{a[y] - c[y]} * (b[x] - c[x]);
}

Whole volume(const Place& a, const Place& b, const Place& c, const Place& d) {
  Whole sum = 0;
  for (std::size_t z = 0; z < 3; ++z) {
    const std::size_t x = (z + 1) % 3;
    const std::size_t y = (z + 2) % 3;
    sum +=
        (Whole{a[x] - d[x]} * (b[y] - d[y]) - Whole{a[y] - d[y]} * (b[x] - d[x])) * (c[z] - d[z]);
  }
  return sum;
}

Vec3 point_at(const Place& p, double unit) {
  return unit *
         Vec3(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
}

class Places {
 public:
  explicit Places(std::uint64_t seed) : seed_(seed) {}
  // From 0 to below `size`.
  std::int64_t number(std::int64_t size) {
    return static_cast<std::int64_t>(random_unit(seed_, next_++) * static_cast<double>(size));
  }
  Place place(std::int64_t size) {
    const std::int64_t x = number(size);
    const std::int64_t y = number(size);
    return {x, y, number(size)};
  }

 private:
  std::uint64_t seed_;
  std::uint64_t next_ = 0;
};

void expect_exact(const std::array<Place, 4>& p, double unit) {
  const auto at = [&](std::size_t i) { return point_at(p[i], unit); };
  EXPECT_EQ(orientation(at(0), at(1), at(2), at(3)), sign_of(volume(p[0], p[1], p[2], p[3])));
  EXPECT_EQ(orientation(at(1), at(0), at(2), at(3)), -sign_of(volume(p[0], p[1], p[2], p[3])));
  const auto in_plane = [&](std::size_t i) { return Point2{at(i).x(), at(i).y()}; };
  EXPECT_EQ(orientation(in_plane(0), in_plane(1), in_plane(2)),
            sign_of(area(p[0], p[1], p[2], 0, 1)));
}

// Small and far from the origin, where rounding takes all of the differences; in units near both
// ends of what is allowed.
TEST(Orientation, IsThatOfWholeNumbers) {
  Places random(1);
  std::size_t flat = 0;
  for (std::size_t i = 0; i < 20'000; ++i) {
    const std::int64_t size = std::array<std::int64_t, 3>{4, 1000, std::int64_t{1} << 39}[i % 3];
    const std::int64_t origin = i % 2 == 0 ? 0 : (std::int64_t{1} << 52);
    const double unit = std::array{1.0, 0x1p-240, 0x1p190}[i % 7 % 3];
    std::array<Place, 4> p;
    for (Place& place : p) {
      place = random.place(size);
      for (std::int64_t& x : place) x += origin;
    }
    flat += volume(p[0], p[1], p[2], p[3]) == 0 ? 1 : 0;
    expect_exact(p, unit);
  }
  EXPECT_GT(flat, 100U);
}

// In a plane, and one unit beside it.
TEST(Orientation, IsExactBesideAPlane) {
  Places random(2);
  for (std::size_t i = 0; i < 20'000; ++i) {
    const Place a = random.place(std::int64_t{1} << 20);
    const Place b = random.place(std::int64_t{1} << 20);
    const Place c = random.place(std::int64_t{1} << 20);
    const std::int64_t s = random.number(1 << 15);
    const std::int64_t t = random.number(1 << 15);
    Place d;
    for (std::size_t x = 0; x < 3; ++x) {
      d[x] = a[x] + s * (b[x] - a[x]) + t * (c[x] - a[x]) + (i % 3 == 2 ? random.number(2) : 0);
    }
    expect_exact({a, b, c, d}, 1);
    Place e;
    for (std::size_t x = 0; x < 3; ++x) e[x] = a[x] + s * (b[x] - a[x]) + (i % 2 == 1 ? 1 : 0);
    expect_exact({a, b, e, c}, 1);
  }
}

// What no product of rounded numbers can hold: each corner has bits of its own.
TEST(Orientation, IsExactFarApart) {
  const Vec3 a(0x1p200, 0, 0);
  const Vec3 b(0, 1, 0);
  const Vec3 c(0, 0, 0x1p-200);
  const Vec3 beyond(std::nextafter(0x1p200, 0x1p201), 0, 0);
  EXPECT_EQ(orientation(a, b, c, a), 0);
  EXPECT_EQ(orientation(a, b, c, beyond), -orientation(a, b, c, Vec3(0, 0, 0)));
  EXPECT_EQ(orientation(Point2{0.5, 0.5}, Point2{12, 12}, Point2{24, 24}), 0);
  EXPECT_EQ(orientation(Point2{0.5, std::nextafter(0.5, 1)}, Point2{12, 12}, Point2{24, 24}),
            orientation(Point2{0, 1}, Point2{12, 12}, Point2{24, 24}));
}

}  // namespace
}  // namespace geolloyd
