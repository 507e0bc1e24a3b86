#include "core/mesh/metric_mean.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "core/base/root.h"
#include "core/base/vec3.h"
#include "core/mesh/principal_direction.h"
#include "core/mesh/tangent_plane.h"

namespace geolloyd {
namespace {

constexpr std::size_t most_spaces = 4;

// The root of the determinant.
double density(const TangentSpace& s) {
  return s.tangent_magnitude * s.bitangent_magnitude * norm(cross(s.tangent, s.bitangent));
}

// Normals of planes have no sign: of the sums with all signs, the longest (the first of several).
Vec3 mean_normal(std::span<const Vec3> normals) {
  Vec3 longest = Vec3::Zero();
  for (unsigned signs = 0; signs < 1U << (normals.size() - 1); ++signs) {
    Vec3 sum = normals[0];
    for (std::size_t i = 1; i < normals.size(); ++i) {
      const bool is_negated = (signs >> (i - 1) & 1U) != 0;
      sum += is_negated ? Vec3(-normals[i]) : normals[i];
    }
    if (dot(sum, sum) > dot(longest, longest)) longest = sum;
  }
  return normalized(longest);
}

// A sum of forms (v . d)^2 of vectors v in a plane.
class SumOfSquares {
 public:
  void add(double x, double y) {
    for (std::size_t i = 0; i < count_; ++i) {
      const double area = x_[i] * y - y_[i] * x;
      determinant_ += area * area;
    }
    x_[count_] = x;
    y_[count_] = y;
    ++count_;
    p_ += (x * x - y * y) / 2;
    q_ += x * y;
    half_trace_ += (x * x + y * y) / 2;
  }

  /// By Cauchy and Binet, the sum of the squares of all pairs' areas.
  [[nodiscard]] double determinant() const { return determinant_; }
  [[nodiscard]] double largest() const { return half_trace_ + std::sqrt(p_ * p_ + q_ * q_); }
  [[nodiscard]] std::array<double, 2> direction() const { return principal_direction(p_, q_); }

 private:
  std::array<double, 2 * most_spaces> x_{};
  std::array<double, 2 * most_spaces> y_{};
  std::size_t count_ = 0;
  double determinant_ = 0;
  double p_ = 0;
  double q_ = 0;
  double half_trace_ = 0;
};

}  // namespace

bool is_metric(const TangentSpace& s) {
  constexpr double smallest_share = 1e-12;
  const double largest =
      s.tangent_magnitude > s.bitangent_magnitude ? s.tangent_magnitude : s.bitangent_magnitude;
  const double found = density(s);
  return found > 0 && found >= smallest_share * largest * largest;
}

TangentSpace metric_mean(std::span<const TangentSpace> spaces) {
  assert(!spaces.empty() && spaces.size() <= most_spaces);
  std::array<Vec3, most_spaces> normals;
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    normals[i] = normalized(cross(spaces[i].tangent, spaces[i].bitangent));
  }
  const Vec3 normal = mean_normal({normals.data(), spaces.size()});
  const auto [first, second] = plane_axes(normal);

  SumOfSquares shapes;
  double mean_density = 1;
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    const TangentSpace& s = spaces[i];
    const Vec3 from = dot(normals[i], normal) < 0 ? Vec3(-normals[i]) : normals[i];
    const double own_density = density(s);
    const double scale = std::sqrt(own_density);
    for (const Vec3& v : {Vec3(s.tangent * (s.tangent_magnitude / scale)),
                          Vec3(s.bitangent * (s.bitangent_magnitude / scale))}) {
      const Vec3 turned = transported(v, from, normal);
      shapes.add(dot(turned, first), dot(turned, second));
    }
    mean_density *= root(own_density, static_cast<int>(spaces.size()));
  }

  const auto [cosine, sine] = shapes.direction();
  const double stretch = shapes.largest() / std::sqrt(shapes.determinant());
  return {cosine * first + sine * second, cosine * second - sine * first,
          std::sqrt(mean_density * stretch), std::sqrt(mean_density / stretch)};
}

}  // namespace geolloyd
