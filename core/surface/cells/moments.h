#pragma once

#include <cstdint>

#include "core/base/loops.h"
#include "core/base/vec3.h"
#include "core/mesh/metric.h"

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

/// The integral of a metric, as integers.
struct MetricIntegral {
  std::int64_t parts[6] = {0, 0, 0, 0, 0, 0};  ///< xx, xy, xz, yy, yz, zz

  MetricIntegral& operator+=(const MetricIntegral& m) {
    for (int i = 0; i < 6; ++i) parts[i] += m.parts[i];
    return *this;
  }
  MetricIntegral& operator-=(const MetricIntegral& m) {
    for (int i = 0; i < 6; ++i) parts[i] -= m.parts[i];
    return *this;
  }
  friend bool operator==(const MetricIntegral&, const MetricIntegral&) = default;
};

/// What a metric M makes of moments: the integrals of M, of M x and of x^T M x.
struct MetricMoments {
  Moments moments;  ///< `first` of M x, `second` of x^T M x
  MetricIntegral metric;

  MetricMoments& operator+=(const MetricMoments& m) {
    moments += m.moments;
    metric += m.metric;
    return *this;
  }
  MetricMoments& operator-=(const MetricMoments& m) {
    moments -= m.moments;
    metric -= m.metric;
    return *this;
  }
  friend MetricMoments operator-(MetricMoments a, const MetricMoments& b) { return a -= b; }
  friend bool operator==(const MetricMoments&, const MetricMoments&) = default;
};

/// The size of the integers' unit: a power of two, so small that rounding is nothing, and so large
/// that the moments of the whole surface are below 2^62.
struct MomentUnit {
  double per_unit = 1;  ///< integers per 1

  MomentUnit() = default;
  /// `longest_square` bounds the square of the length of unit vectors.
  explicit MomentUnit(double whole_area, double longest_square = 1) {
    const double most = 0x1p60 / longest_square;  // |x|^2 <= 3
    while (whole_area * per_unit > most) per_unit /= 2;
    while (whole_area > 0 && whole_area * per_unit * 2 <= most) per_unit *= 2;
  }

  [[nodiscard]] Moments round(const PieceMoments& piece) const {
    return {to_integer(piece.area),
            {to_integer(piece.first.x()), to_integer(piece.first.y()), to_integer(piece.first.z())},
            to_integer(piece.second)};
  }
  [[nodiscard]] MetricMoments round(const PieceMoments& piece, const Metric& metric) const {
    const Metric whole = piece.area * metric;
    return {round(piece),
            {{to_integer(whole.xx), to_integer(whole.xy), to_integer(whole.xz),
              to_integer(whole.yy), to_integer(whole.yz), to_integer(whole.zz)}}};
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
    return (static_cast<double>(m.second) - 2 * dot(site, first(m)) +
            dot(site, site) * static_cast<double>(m.area)) /
           per_unit;
  }
  /// The integral of (x - site)^T M (x - site).
  [[nodiscard]] double energy(const Moments& m, const MetricIntegral& metric,
                              const Vec3& site) const {
    return (static_cast<double>(m.second) - 2 * dot(site, first(m)) +
            in_units(metric).square(site)) /
           per_unit;
  }
  /// Of the latter energy as a function of the site.
  [[nodiscard]] Vec3 gradient(const Moments& m, const MetricIntegral& metric,
                              const Vec3& site) const {
    return (in_units(metric) * site - first(m)) * (2 / per_unit);
  }
  [[nodiscard]] Metric metric(const MetricIntegral& m) const {
    return (1 / per_unit) * in_units(m);
  }

 private:
  [[nodiscard]] std::int64_t to_integer(double x) const {
    return static_cast<std::int64_t>(x * per_unit);
  }
  [[nodiscard]] double to_double(std::int64_t x) const { return static_cast<double>(x) / per_unit; }
  static Vec3 first(const Moments& m) {
    return {static_cast<double>(m.first[0]), static_cast<double>(m.first[1]),
            static_cast<double>(m.first[2])};
  }
  static Metric in_units(const MetricIntegral& m) {
    const auto part = [&](int i) { return static_cast<double>(m.parts[i]); };
    return {part(0), part(1), part(2), part(3), part(4), part(5)};
  }
};

}  // namespace geolloyd
