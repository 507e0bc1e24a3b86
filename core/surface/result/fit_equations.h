#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/surface/result/sample_projection.h"

namespace geolloyd {

/// What the samples of a triangle ask of its corners' moves along its normal: the symmetric matrix
/// of sums of weight * share * share, and the sums of weight * share * height.
struct Pull {
  std::array<std::array<double, 3>, 3> matrix{};
  std::array<double, 3> height{};

  void add(const Sample& sample, const Foot& foot, const Vec3& normal) {
    const double above = dot(foot.away, normal);
    for (std::size_t i = 0; i < 3; ++i) {
      const double weighted = sample.weight * foot.barycentric[i];
      height[i] += weighted * above;
      for (std::size_t j = 0; j < 3; ++j) matrix[i][j] += weighted * foot.barycentric[j];
    }
  }
};

/// The moves of vertices after which the sum of the square distances from samples to the planes of
/// their triangles is least, as in Garland and Heckbert 1997, shared among the corners by where the
/// samples are. Solved by conjugate gradients on the normal equations, preconditioned by their
/// blocks on the diagonal.
class FitEquations {
 public:
  /// `reluctance` to move sideways, over that to move along the normal. The first `held` vertices
  /// do not move.
  FitEquations(const MovingRemesh& remesh, const SurfaceSamples& samples,
               const SampleProjection& projection, double reluctance, std::size_t held,
               Executor& executor);

  [[nodiscard]] std::vector<Vec3> solve() const;

 private:
  void gather_samples();
  void find_blocks(double reluctance);
  void hold(std::vector<Vec3>& x) const;
  [[nodiscard]] std::vector<Vec3> times(const std::vector<Vec3>& x) const;
  [[nodiscard]] std::vector<Vec3> precondition(const std::vector<Vec3>& x) const;

  const MovingRemesh& remesh_;
  const SurfaceSamples& samples_;
  const SampleProjection& projection_;
  std::size_t held_;
  Executor& executor_;
  std::vector<Vec3> normal_;            // per triangle
  std::vector<Pull> pull_;              // per triangle
  std::vector<Eigen::Matrix3d> block_;  // per vertex
  std::vector<double> damping_;         // per vertex
  std::vector<double> stiffness_;       // per vertex, sideways
};

}  // namespace geolloyd
