#pragma once

#include <span>
#include <vector>

#include "core/mesh/metric.h"
#include "core/surface/result/moving_remesh.h"

namespace geolloyd {

/// What a fit must not do to triangles: no angle gets smaller than the smallest one was at first,
/// less 2 degrees, and no triangle turns by more than 30 degrees. Angles and quality are those in
/// `metric`, of each vertex of the remesh, if there is one.
class FitGuards {
 public:
  FitGuards(MovingRemesh& remesh, std::span<const Metric> metric);

  [[nodiscard]] double mean_quality() const;
  /// Corners of bad triangles go back to where they were before, until there are none.
  void undo_bad_moves(const std::vector<Vec3>& before);

 private:
  [[nodiscard]] bool is_bad(TriangleId t) const;
  [[nodiscard]] double largest_cosine(TriangleId t) const;
  [[nodiscard]] double largest_cosine_of_all() const;

  MovingRemesh& remesh_;
  std::span<const Metric> metric_;  // per vertex; empty: none
  double most_cosine_;              // of a smallest angle
};

}  // namespace geolloyd
