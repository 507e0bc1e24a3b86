#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/vec3.h"

namespace geolloyd {

/// A symmetric matrix M, positive definite where it measures: a displacement d is sqrt(d^T M d)
/// long.
struct Metric {
  double xx = 1;
  double xy = 0;
  double xz = 0;
  double yy = 1;
  double yz = 0;
  double zz = 1;

  static Metric zero() { return {0, 0, 0, 0, 0, 0}; }
  /// d d^T.
  static Metric square_of(const Vec3& d) {
    return {d.x() * d.x(), d.x() * d.y(), d.x() * d.z(),
            d.y() * d.y(), d.y() * d.z(), d.z() * d.z()};
  }

  Metric& operator+=(const Metric& m) {
    xx += m.xx;
    xy += m.xy;
    xz += m.xz;
    yy += m.yy;
    yz += m.yz;
    zz += m.zz;
    return *this;
  }
  Metric& operator*=(double factor) {
    for (double* x : {&xx, &xy, &xz, &yy, &yz, &zz}) *x *= factor;
    return *this;
  }
  friend Metric operator+(Metric a, const Metric& b) { return a += b; }
  friend Metric operator*(double factor, Metric m) { return m *= factor; }
  friend Vec3 operator*(const Metric& m, const Vec3& v) {
    return {m.xx * v.x() + m.xy * v.y() + m.xz * v.z(), m.xy * v.x() + m.yy * v.y() + m.yz * v.z(),
            m.xz * v.x() + m.yz * v.y() + m.zz * v.z()};
  }
  friend bool operator==(const Metric&, const Metric&) = default;

  [[nodiscard]] double trace() const { return xx + yy + zz; }
  [[nodiscard]] double dot(const Vec3& a, const Vec3& b) const {
    return geolloyd::dot(a, *this * b);
  }
  [[nodiscard]] double square(const Vec3& d) const { return dot(d, d); }
  [[nodiscard]] double length(const Vec3& d) const { return std::sqrt(square(d)); }

  /// Of a metric with the eigenvalues s, 1/s and 1: the root of the larger of the first two, by
  /// which a displacement may be longer than elsewhere.
  [[nodiscard]] double largest_stretch() const {
    const double sum = std::max(trace() - 1, 2.0);
    return std::sqrt((sum + std::sqrt(sum * sum - 4)) / 2);
  }

  /// The inverse times a vector, by Cramer's rule; zero where there is no inverse.
  [[nodiscard]] Vec3 solve(const Vec3& v) const {
    const Vec3 a(xx, xy, xz);
    const Vec3 b(xy, yy, yz);
    const Vec3 c(xz, yz, zz);
    const double volume = geolloyd::dot(a, cross(b, c));
    if (!(volume > 0)) return Vec3::Zero();
    return Vec3(geolloyd::dot(v, cross(b, c)), geolloyd::dot(a, cross(v, c)),
                geolloyd::dot(a, cross(b, v))) /
           volume;
  }
};

/// The triangular root R of a metric R^T R (Cholesky): what R maps is measured as usual.
class MetricRoot {
 public:
  explicit MetricRoot(const Metric& m)
      : xx_(std::sqrt(m.xx)),
        xy_(m.xy / xx_),
        xz_(m.xz / xx_),
        yy_(std::sqrt(m.yy - xy_ * xy_)),
        yz_((m.yz - xy_ * xz_) / yy_),
        zz_(std::sqrt(m.zz - xz_ * xz_ - yz_ * yz_)) {}

  [[nodiscard]] Vec3 operator()(const Vec3& v) const {
    return {xx_ * v.x() + xy_ * v.y() + xz_ * v.z(), yy_ * v.y() + yz_ * v.z(), zz_ * v.z()};
  }
  /// R^T v.
  [[nodiscard]] Vec3 transposed(const Vec3& v) const {
    return {xx_ * v.x(), xy_ * v.x() + yy_ * v.y(), xz_ * v.x() + yz_ * v.y() + zz_ * v.z()};
  }

 private:
  double xx_, xy_, xz_, yy_, yz_, zz_;
};

}  // namespace geolloyd
