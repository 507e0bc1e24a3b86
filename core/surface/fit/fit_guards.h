#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/metric.h"
#include "core/surface/fit/moving_remesh.h"

namespace geolloyd {

/// What a fit must not do to triangles: no angle gets smaller than the smallest one was at first,
/// less 2 degrees where that was above 8, no triangle turns by more than 75 degrees, and no vertex
/// rises above the remesh by more than three fifths of a side: samples do not see how far out it
/// is. Angles are those in `metric`, of each vertex of the remesh, if there is one.
class FitGuards {
 public:
  /// `side` of a triangle.
  FitGuards(const MovingRemesh& remesh, std::span<const Metric> metric, double side);

  /// Per vertex: 1 where it is one, or a corner of a bad triangle.
  [[nodiscard]] std::vector<std::uint8_t> bad_vertices() const;
  /// Marks the corners of triangles one of whose angles is below 28 degrees, and smaller by 2 than
  /// the smallest one of that triangle was.
  void add_narrowed(std::vector<std::uint8_t>& is_bad_one) const;
  /// Marks the corners of triangles that pass through each other, if none did at first: where some
  /// did the shape is lost, and distance decides.
  void add_crossing(std::vector<std::uint8_t>& is_bad_one, Executor& executor) const;

 private:
  [[nodiscard]] bool is_bad(TriangleId t) const;
  [[nodiscard]] double largest_cosine(TriangleId t) const;

  const MovingRemesh& remesh_;
  std::span<const Metric> metric_;  // per vertex; empty: none
  double most_cosine_ = 1;          // of a smallest angle
  double highest_;
  std::vector<Vec3> normal_;          // per vertex: at first
  std::vector<double> first_cosine_;  // per triangle: of its smallest angle, at first
};

}  // namespace geolloyd
