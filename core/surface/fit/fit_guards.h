#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/metric.h"
#include "core/surface/fit/moving_remesh.h"

namespace geolloyd {

/// What a fit must not do to triangles: no angle gets smaller than the smallest one was at first,
/// less 2 degrees, and no triangle turns by more than 75 degrees. Angles are those in `metric`, of
/// each vertex of the remesh, if there is one.
class FitGuards {
 public:
  FitGuards(const MovingRemesh& remesh, std::span<const Metric> metric);

  /// Per vertex: 1 where it is one.
  [[nodiscard]] std::vector<std::uint8_t> corners_of_bad_triangles() const;

 private:
  [[nodiscard]] bool is_bad(TriangleId t) const;
  [[nodiscard]] double largest_cosine(TriangleId t) const;
  [[nodiscard]] double largest_cosine_of_all() const;

  const MovingRemesh& remesh_;
  std::span<const Metric> metric_;  // per vertex; empty: none
  double most_cosine_;              // of a smallest angle
};

}  // namespace geolloyd
