#include "core/mesh/exact_signs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace geolloyd {
namespace {

// How far rounding takes a determinant at most, of the sum of its products' magnitudes.
constexpr double unit = 0x1p-53;
constexpr double error_in_plane = (3 + 16 * unit) * unit;
constexpr double error_in_space = (7 + 56 * unit) * unit;

int sign_of(double x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

// Whether rounding cannot have reached the sign. Where all products are 0, so is their sum.
bool is_certain(double determinant, double error) {
  return error == 0 || std::abs(determinant) > error;
}

// A rounded number and what it lacks: together exact.
struct Pair {
  double high;
  double low;
};

Pair sum(double a, double b) {
  const double high = a + b;
  const double b_part = high - a;
  const double a_part = high - b_part;
  return {high, (a - a_part) + (b - b_part)};
}

// In two halves of 26 bits.
Pair split(double a) {
  constexpr double splitter = 0x1p27 + 1;
  const double c = splitter * a;
  const double high = c - (c - a);
  return {high, a - high};
}

Pair product(double a, double b) {
  const double high = a * b;
  const auto [a_high, a_low] = split(a);
  const auto [b_high, b_low] = split(b);
  return {high, ((a_high * b_high - high) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

// A sum without rounding: numbers whose bits do not overlap, from small to large.
class ExactSum {
 public:
  void add(double number) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const auto [high, low] = sum(number, part_[i]);
      if (low != 0) part_[kept++] = low;
      number = high;
    }
    if (number != 0) part_[kept++] = number;
    count_ = kept;
  }
  void add(const Pair& pair) {
    add(pair.low);
    add(pair.high);
  }
  void add_product(const Pair& ab, double c) {
    add(product(ab.low, c));
    add(product(ab.high, c));
  }
  // The largest part outweighs all others.
  [[nodiscard]] int sign() const { return count_ == 0 ? 0 : sign_of(part_[count_ - 1]); }

 private:
  static constexpr std::size_t most = 96;  // four parts of each of 24 products of three
  std::array<double, most> part_{};
  std::size_t count_ = 0;
};

Pair negative(const Pair& pair) {
  return {-pair.high, -pair.low};
}

int exact_orientation(const Point2& a, const Point2& b, const Point2& c) {
  ExactSum determinant;
  for (const auto& [p, q] : {std::array{&a, &b}, std::array{&b, &c}, std::array{&c, &a}}) {
    determinant.add(product((*p)[0], (*q)[1]));
    determinant.add(negative(product((*p)[1], (*q)[0])));
  }
  return determinant.sign();
}

// Adds `sign` times the determinant of three points as columns.
void add_determinant(const Vec3& p, const Vec3& q, const Vec3& r, double sign, ExactSum& sum) {
  const std::array<const Vec3*, 3> cyclic = {&p, &q, &r};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& x = *cyclic[i];
    const Vec3& y = *cyclic[(i + 1) % 3];
    const double z = sign * (*cyclic[(i + 2) % 3]).z();
    sum.add_product(product(x.x(), y.y()), z);
    sum.add_product(negative(product(x.y(), y.x())), z);
  }
}

int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  ExactSum determinant;
  add_determinant(a, b, c, 1, determinant);
  add_determinant(a, b, d, -1, determinant);
  add_determinant(a, c, d, 1, determinant);
  add_determinant(b, c, d, -1, determinant);
  return determinant.sign();
}

}  // namespace

int orientation(const Point2& a, const Point2& b, const Point2& c) {
  const double left = (a[0] - c[0]) * (b[1] - c[1]);
  const double right = (a[1] - c[1]) * (b[0] - c[0]);
  const double determinant = left - right;
  const double error = error_in_plane * (std::abs(left) + std::abs(right));
  return is_certain(determinant, error) ? sign_of(determinant) : exact_orientation(a, b, c);
}

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double adx = a.x() - d.x();
  const double ady = a.y() - d.y();
  const double adz = a.z() - d.z();
  const double bdx = b.x() - d.x();
  const double bdy = b.y() - d.y();
  const double bdz = b.z() - d.z();
  const double cdx = c.x() - d.x();
  const double cdy = c.y() - d.y();
  const double cdz = c.z() - d.z();
  const double determinant =
      adz * (bdx * cdy - cdx * bdy) + bdz * (cdx * ady - adx * cdy) + cdz * (adx * bdy - bdx * ady);
  const double magnitudes = (std::abs(bdx * cdy) + std::abs(cdx * bdy)) * std::abs(adz) +
                            (std::abs(cdx * ady) + std::abs(adx * cdy)) * std::abs(bdz) +
                            (std::abs(adx * bdy) + std::abs(bdx * ady)) * std::abs(cdz);
  return is_certain(determinant, error_in_space * magnitudes) ? sign_of(determinant)
                                                              : exact_orientation(a, b, c, d);
}

}  // namespace geolloyd
