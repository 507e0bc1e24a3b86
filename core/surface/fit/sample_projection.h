#pragma once

#include <array>
#include <cmath>
#include <span>
#include <utility>
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

/// The samples of a surface, projected onto a remesh. The search for the nearest triangle begins at
/// the vertex that a sample's place belongs to, and goes from triangle to triangle.
class SampleProjection {
 public:
  SampleProjection(const SampleSet& samples, const MovingRemesh& remesh, Executor& executor)
      : samples_(samples), remesh_(remesh), executor_(executor) {}

  /// Where to begin the search for the triangle of each sample, instead of at its vertex.
  void begin_at(std::vector<TriangleId> triangles) { triangle_ = std::move(triangles); }
  void begin_at(std::size_t sample, TriangleId triangle) { triangle_[sample] = triangle; }
  /// Onto the remesh as it now is. Searches begin where the last ones ended.
  FitError project();

  /// Of the last projection, per sample: the triangle, or no_id where the vertex has none.
  [[nodiscard]] std::span<const TriangleId> triangles() const { return triangle_; }
  [[nodiscard]] double square_distance(std::size_t sample) const {
    return square_distance_[sample];
  }
  [[nodiscard]] double distance(std::size_t sample) const {
    return std::sqrt(square_distance_[sample]);
  }

  /// Per vertex of the remesh: of the samples on its triangles.
  [[nodiscard]] std::vector<double> largest_at_vertices() const;

  [[nodiscard]] Foot foot_on(TriangleId t, const Vec3& point) const;

 private:
  [[nodiscard]] Foot foot_of(std::size_t sample) const;

  const SampleSet& samples_;
  const MovingRemesh& remesh_;
  Executor& executor_;
  std::vector<TriangleId> triangle_;     // per sample
  std::vector<double> square_distance_;  // per sample
};

}  // namespace geolloyd
