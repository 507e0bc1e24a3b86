#include "core/fields/metric_mean.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/base/vec3.h"
#include "core/fields/principal_direction.h"
#include "core/fields/tangent_plane.h"

namespace geolloyd {
namespace {

constexpr std::size_t most_spaces = 4;

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

// The mean of symmetric matrices (size + p, q; q, size - p) in a plane.
class RootMean {
 public:
  explicit RootMean(PlaneAxes axes) : axes_(std::move(axes)) {}

  // The root of M is (M + r I) / sqrt(trace M + 2 r) with r = sqrt(det M).
  void add(const TangentSpace& s, const Vec3& tangent, const Vec3& bitangent) {
    double trace = 0;
    double p = 0;
    double q = 0;
    for (const Vec3& v :
         {Vec3(s.tangent_magnitude * tangent), Vec3(s.bitangent_magnitude * bitangent)}) {
      const double x = dot(v, axes_.first);
      const double y = dot(v, axes_.second);
      trace += x * x + y * y;
      p += (x * x - y * y) / 2;
      q += x * y;
    }
    const double root =
        s.tangent_magnitude * s.bitangent_magnitude * norm(cross(tangent, bitangent));
    const double doubled_size = std::sqrt(trace + 2 * root);
    if (!(doubled_size > 0)) return;
    size_ += doubled_size / 2;
    p_ += p / doubled_size;
    q_ += q / doubled_size;
    stretch_ += std::sqrt(p * p + q * q) / doubled_size;
  }

  [[nodiscard]] TangentSpace of(std::size_t count) const {
    const double together = std::sqrt(p_ * p_ + q_ * q_);
    const double stretch = stretch_ > 0 ? together * (2 - together / stretch_) : 0;
    const auto [cosine, sine] = principal_direction(p_, q_);
    const auto number = static_cast<double>(count);
    return {cosine * axes_.first + sine * axes_.second, cosine * axes_.second - sine * axes_.first,
            (size_ + stretch) / number, std::max(0.0, size_ - stretch) / number};
  }

 private:
  PlaneAxes axes_;
  double size_ = 0;
  double p_ = 0;
  double q_ = 0;
  double stretch_ = 0;  // all there would be of p and q if all directions were the same
};

}  // namespace

bool has_plane(const TangentSpace& s) {
  constexpr double smallest_sine = 1e-6;
  return norm(cross(s.tangent, s.bitangent)) >= smallest_sine;
}

TangentSpace metric_mean(std::span<const TangentSpace> spaces) {
  assert(!spaces.empty() && spaces.size() <= most_spaces);
  std::array<Vec3, most_spaces> normals;
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    normals[i] = normalized(cross(spaces[i].tangent, spaces[i].bitangent));
  }
  const Vec3 normal = mean_normal({normals.data(), spaces.size()});
  RootMean mean(plane_axes(normal));
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    const Vec3 from = dot(normals[i], normal) < 0 ? Vec3(-normals[i]) : normals[i];
    mean.add(spaces[i], transported(spaces[i].tangent, from, normal),
             transported(spaces[i].bitangent, from, normal));
  }
  return mean.of(spaces.size());
}

}  // namespace geolloyd
