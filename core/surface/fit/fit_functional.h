#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
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

/// What a fit measures by. Unit frame.
struct FitSetting {
  std::size_t on_curves = 0;      ///< the first vertices: normals there lie between faces
  std::size_t held = 0;           ///< the first vertices: they do not move
  double side = 0;                ///< of a triangle
  std::vector<double> area = {};  ///< per vertex: of a triangle, asked for
  /// Of the whole remesh, where this is a part of one.
  struct Whole {
    double weight = 0;       ///< of all samples
    double mean_square = 0;  ///< of their distances
  };
  std::optional<Whole> whole = {};
};

/// How far the vertices of a remesh go in a round of a fit.
struct FitDescent {
  double longest_step = 0;  ///< of a vertex in an iteration, in sides of a triangle
  int iterations = 0;
  // As in PointDescent:
  double least_gain = 1e-6;
  std::function<bool()> keep_going = {};
};

/// The joint functional of a fit: square distances from samples of the surface to the remesh over
/// h^2, h being the side of its triangles, in the mean; and the strain of its triangles, in the
/// mean, times a price.
///
/// Feet and directions are those of the start of a round. A sample pulls along the normal of its
/// triangle. Where its foot is on an edge or a corner, and the sample is not above, it pulls along
/// the way from its foot: otherwise an ear would retreat for good. Far samples count more. A vertex
/// whose triangles and samples are all in a plane stays in it.
class FitFunctional {
 public:
  FitFunctional(const MovingRemesh& remesh, const SampleSet& samples,
                const SampleProjection& projection, std::span<const Metric> metric,
                FitSetting setting, Executor& executor);

  [[nodiscard]] const FitSetting& setting() const { return setting_; }
  /// Of a triangle's strain, from the next round on.
  void set_price(double price) { price_ = price; }
  /// From the remesh and the projection as they are.
  void begin_round();
  /// Of the start of the round, with the boost that is set.
  [[nodiscard]] double value() const;
  /// Of that, the distances.
  [[nodiscard]] double distances() const { return per_square_ * squares_; }

  /// Where each triangle's strain counts `boost` times, and moves have a price: `reluctance` times
  /// that of the samples' pull.
  void set_boost(std::span<const double> boost, double reluctance);
  /// Where vertices are after a descent from where they are.
  [[nodiscard]] std::vector<Vec3> descend(const FitDescent& descent) const;

 private:
  // After the moves of the round.
  double evaluate(const std::vector<Vec3>& positions, std::vector<Vec3>& gradient) const;

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

  void find_strains();
  void find_pulls();
  void find_squares();
  void find_planes();
  [[nodiscard]] bool is_plane(std::size_t v, const Vec3& normal) const;
  void add_sample(std::size_t i, TriangleId t, Share& share) const;
  [[nodiscard]] double weight_of(double square_distance) const;
  [[nodiscard]] std::array<Vec3, 3> corners(std::size_t t, const std::vector<Vec3>& at) const;
  [[nodiscard]] Slope slope_of(std::size_t t, const std::vector<Vec3>& at) const;
  void add_strain(std::size_t t, const std::vector<Vec3>& at, Slope& slope) const;
  void add_pull(const Pull& pull, const Vec3& direction, const std::array<Vec3, 3>& move,
                Slope& slope) const;

  const MovingRemesh& remesh_;
  const SampleSet& samples_;
  const SampleProjection& projection_;
  std::span<const Metric> metric_;  // per vertex; empty: none
  FitSetting setting_;
  Executor& executor_;
  double price_ = 0;                    // of a triangle's strain
  double mean_square_ = 0;              // of distances
  double per_square_ = 0;               // price of a sample's square distance, per weight
  double squares_ = 0;                  // of the start of the round, weighted
  std::vector<double> area_;            // per triangle: asked for
  std::vector<MetricRoot> root_;        // per triangle; empty: no metric
  std::vector<Share> share_;            // per triangle
  std::vector<Vec3> from_;              // per vertex: at the start of the round
  std::vector<Vec3> plane_;             // per vertex: normal of the plane it stays in; zero: none
  std::vector<double> boost_;           // per triangle
  std::vector<double> resistance_;      // per vertex, to a move
  std::vector<double> preconditioner_;  // per vertex: the inverse of what it resists a move with
  mutable std::vector<Slope> slope_;    // per triangle; scratch
};

}  // namespace geolloyd
