#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "core/surface/fit/moving_remesh.h"
#include "core/surface/fit/surface_fit.h"
#include "core/surface/fit/surface_samples.h"

namespace geolloyd {

/// Where on the remesh a sample is projected to.
struct Foot {
  TriangleId triangle = no_id;
  std::array<double, 3> barycentric = {0, 0, 0};
  Vec3 away = Vec3::Zero();  ///< to the sample
};

/// The samples of a surface, projected onto a remesh: each onto the nearest of the triangles at the
/// vertex that its place belongs to.
class SampleProjection {
 public:
  SampleProjection(const SurfaceSamples& samples, const MovingRemesh& remesh, Executor& executor)
      : samples_(samples), remesh_(remesh), executor_(executor) {}

  /// Onto the remesh as it now is.
  FitError project();

  /// Of the last projection, per sample: the triangle, or no_id where the vertex has none.
  [[nodiscard]] std::span<const TriangleId> triangles() const { return triangle_; }
  [[nodiscard]] double square_distance(std::size_t sample) const {
    return square_distance_[sample];
  }
  [[nodiscard]] double distance(std::size_t sample) const {
    return std::sqrt(square_distance_[sample]);
  }

  [[nodiscard]] Foot foot_on(TriangleId t, const Vec3& point) const;

 private:
  [[nodiscard]] Foot foot_of(const Sample& sample) const;

  const SurfaceSamples& samples_;
  const MovingRemesh& remesh_;
  Executor& executor_;
  std::vector<TriangleId> triangle_;     // per sample
  std::vector<double> square_distance_;  // per sample
};

}  // namespace geolloyd
