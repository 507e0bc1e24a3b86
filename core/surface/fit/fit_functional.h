#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/bucketing.h"
#include "core/mesh/metric.h"
#include "core/surface/fit/sample_projection.h"
#include "core/surface/fit/triangle_strain.h"

namespace geolloyd {

/// What samples of a triangle ask of its corners' moves: the sum of
/// weight * (height - sum of share * move along the direction)^2.
struct Pull {
  std::array<std::array<double, 3>, 3> matrix{};  ///< sums of weight * share * share
  std::array<double, 3> height{};                 ///< sums of weight * share * height

  void add(double weight, const std::array<double, 3>& share, double height_of_sample) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double weighted = weight * share[i];
      height[i] += weighted * height_of_sample;
      for (std::size_t j = 0; j < 3; ++j) matrix[i][j] += weighted * share[j];
    }
  }
};

/// The joint functional of a fit: square distances from samples of the surface to the remesh over
/// h^2, h being the side of its triangles, in the mean; and the strain of its triangles, in the
/// mean, times a price.
///
/// Of a round, feet and directions are fixed: those of the positions at its start. A sample pulls
/// along the normal of its triangle, or, where its foot is on an edge or a corner and it is not
/// above, along the way to it: an ear would retreat for good else. What is far counts more.
class FitFunctional {
 public:
  FitFunctional(const MovingRemesh& remesh, const SurfaceSamples& samples,
                const SampleProjection& projection, std::span<const Metric> metric, bool is_graded,
                std::size_t held, Executor& executor);

  /// Side of a triangle. Unit frame.
  [[nodiscard]] double side() const { return side_; }
  /// Of strain.
  void set_price(double price) {
    price_ = price / static_cast<double>(share_.size());
    begin_round();
  }
  /// From the remesh and the projection as they are.
  void begin_round();
  /// Of the start of the round.
  [[nodiscard]] double value() const { return value_; }

  /// Where each triangle's strain counts `boost` times, and moves have a price: `reluctance` times
  /// that of the samples' pull.
  void set_prices(std::span<const double> boost, double reluctance);
  /// After the moves of the round.
  double evaluate(const std::vector<Vec3>& positions, std::vector<Vec3>& gradient) const;
  /// Per vertex: the inverse of what it resists a move with.
  [[nodiscard]] std::span<const double> preconditioner() const { return preconditioner_; }

 private:
  struct Oblique {
    Pull pull;
    Vec3 direction;
  };
  // All that a triangle has a part in.
  struct Share {
    Vec3 normal = Vec3::Zero();
    Pull pull;  // along the normal
    std::vector<Oblique> oblique;
    TriangleStrain strain;
  };
  // Of moves.
  struct Slope {
    double value = 0;
    std::array<Vec3, 3> gradient = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  };

  void find_areas(bool is_graded);
  void find_strains();
  void find_pulls();
  void find_value();
  void add_sample(std::size_t i, TriangleId t, Share& share) const;
  [[nodiscard]] double weight_of(double square_distance) const;
  [[nodiscard]] std::array<Vec3, 3> corners(std::size_t t, const std::vector<Vec3>& at) const;
  [[nodiscard]] Slope slope_of(std::size_t t, const std::vector<Vec3>& at) const;
  void add_strain(std::size_t t, const std::vector<Vec3>& at, Slope& slope) const;
  void add_pull(const Pull& pull, const Vec3& direction, const std::array<Vec3, 3>& move,
                Slope& slope) const;

  const MovingRemesh& remesh_;
  const SurfaceSamples& samples_;
  const SampleProjection& projection_;
  std::span<const Metric> metric_;  // per vertex; empty: none
  std::size_t held_;
  Executor& executor_;
  double side_ = 0;
  double price_ = 0;        // of a triangle's strain
  double mean_square_ = 0;  // of distances
  double per_square_ = 0;   // price of a sample's square distance, per weight
  double value_ = 0;
  std::vector<double> area_;        // per triangle: asked for
  std::vector<MetricRoot> root_;    // per triangle; empty: no metric
  std::vector<Share> share_;        // per triangle
  std::vector<Vec3> from_;          // per vertex: at the start of the round
  std::vector<double> boost_;       // per triangle
  std::vector<double> resistance_;  // per vertex, to a move
  std::vector<double> preconditioner_;
  mutable std::vector<Slope> slope_;  // per triangle; scratch
};

}  // namespace geolloyd
