#pragma once

#include <cstdint>

#include "core/base/loops.h"
#include "core/base/vec3.h"

namespace geolloyd {

/// Area, and the integrals of x and of |x|^2, over a piece of a surface, in the unit frame
/// (fine_mesh.h); all counted by a density where sizes vary. Doubles, for one piece.
struct PieceMoments {
  double area = 0;
  Vec3 first = Vec3::Zero();
  double second = 0;
};

/// Those of a triangle with the area `area`.
inline PieceMoments moments_of_triangle(const Vec3& a, const Vec3& b, const Vec3& c, double area) {
  const Vec3 sum = a + b + c;
  return {area, sum * (area / 3),
          (dot(a, a) + dot(b, b) + dot(c, c) + dot(sum, sum)) * (area / 12)};
}

/// The same as integers, so that sums are exact: any order of additions, by any number of threads,
/// gives the same bits, and what was added can be taken away again.
struct Moments {
  std::int64_t area = 0;
  std::int64_t first[3] = {0, 0, 0};
  std::int64_t second = 0;

  Moments& operator+=(const Moments& m) {
    area += m.area;
    for (int i = 0; i < 3; ++i) first[i] += m.first[i];
    second += m.second;
    return *this;
  }
  Moments& operator-=(const Moments& m) {
    area -= m.area;
    for (int i = 0; i < 3; ++i) first[i] -= m.first[i];
    second -= m.second;
    return *this;
  }
  friend Moments operator-(Moments a, const Moments& b) { return a -= b; }
  friend bool operator==(const Moments&, const Moments&) = default;
};

/// The size of the integers' unit: a power of two, so small that rounding is nothing, and so large
/// that the moments of the whole surface are below 2^62.
struct MomentUnit {
  double per_unit = 1;  ///< integers per 1

  MomentUnit() = default;
  explicit MomentUnit(double whole_area) {
    constexpr double most = 0x1p60;  // |x|^2 <= 3
    while (whole_area * per_unit > most) per_unit /= 2;
    while (whole_area > 0 && whole_area * per_unit * 2 <= most) per_unit *= 2;
  }

  [[nodiscard]] Moments round(const PieceMoments& piece) const {
    return {to_integer(piece.area),
            {to_integer(piece.first.x()), to_integer(piece.first.y()), to_integer(piece.first.z())},
            to_integer(piece.second)};
  }
  [[nodiscard]] double area(const Moments& m) const { return to_double(m.area); }
  /// Of moments with an area.
  [[nodiscard]] Vec3 centroid(const Moments& m) const {
    const auto area = static_cast<double>(m.area);
    return {static_cast<double>(m.first[0]) / area, static_cast<double>(m.first[1]) / area,
            static_cast<double>(m.first[2]) / area};
  }
  /// The integral of |x - site|^2.
  [[nodiscard]] double energy(const Moments& m, const Vec3& site) const {
    const Vec3 first(static_cast<double>(m.first[0]), static_cast<double>(m.first[1]),
                     static_cast<double>(m.first[2]));
    return (static_cast<double>(m.second) - 2 * dot(site, first) +
            dot(site, site) * static_cast<double>(m.area)) /
           per_unit;
  }

 private:
  [[nodiscard]] std::int64_t to_integer(double x) const {
    return static_cast<std::int64_t>(x * per_unit);
  }
  [[nodiscard]] double to_double(std::int64_t x) const { return static_cast<double>(x) / per_unit; }
};

}  // namespace geolloyd
