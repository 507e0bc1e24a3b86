#pragma once

#include <cstddef>
#include <vector>

#include "core/surface/substrate/fine_mesh.h"

namespace geolloyd {

/// A section of the boundary or of a feature between two corners, or a loop without corners. Sites
/// on it are evenly spaced and fixed until they are fitted.
struct FeatureCurve {
  std::vector<VertexId> vertices;  ///< from end to end; a loop ends where it begins
  std::vector<double> arc;         ///< per vertex: the length up to it, unit frame, counted by the
                                   ///< inverse sizing
  double of_chords = 0;            ///< the length of chords about a spacing of the last level long;
                                   ///< up to half as much again on a feature that curves by more
  std::size_t least_intervals = 1;
  double first_step = 1;  ///< the first interval, in ordinary ones; longer beside an acute corner
  double last_step = 1;
  bool is_loop = false;  ///< one end, which is no corner

  [[nodiscard]] double length() const { return arc.back(); }
  /// Where site i of so many intervals is, as a length from the start.
  [[nodiscard]] double place(std::size_t i, std::size_t intervals) const;
  /// Intervals with chords about `spacing` long, and no more than it has edges.
  [[nodiscard]] std::size_t intervals(double spacing) const {
    return intervals_in(of_chords, spacing);
  }
  /// How often `spacing` goes into a length, between the same limits.
  [[nodiscard]] std::size_t intervals_in(double length, double spacing) const;

  /// The point at a length from the start.
  [[nodiscard]] Vec3 point_at(const FineMesh& mesh, double at) const;
  /// The length of a displacement, counted as edges are counted there.
  [[nodiscard]] double sized_length(const FineMesh& mesh, double at,
                                    const Vec3& displacement) const;

 private:
  [[nodiscard]] std::size_t edge_at(double at) const;
};

}  // namespace geolloyd
