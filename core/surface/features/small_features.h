#pragma once

#include <vector>

#include "core/surface/substrate/surface_input.h"

namespace geolloyd {

/// Lengths of edges that keep what is smaller than sites are apart, by the local feature size
/// (Ruppert 1995): a ninth of a loop of features or boundary, and the distance of two curves
/// across the surface.
struct SmallFeatures {
  std::vector<double> sizes;  ///< per vertex of the surface, in spacings, with those that it has;
                              ///< empty: nothing is small
  double share = 0;           ///< of all vertices: those that the small sizes take
  /// Some edges are more than half as long again as they were to be, as the lengths asked for would
  /// have taken too many vertices.
  bool is_limited = false;
};

/// Loops of features shorter than this are too small for sites of their own. Spacings.
inline constexpr double shortest_kept_loop = 1.5;
/// Holes shorter than this are as small as a triangle, which stands for them.
inline constexpr double shortest_kept_hole = 3;

/// `spacing` is that of evenly spread sites, in the unit frame. Sizes grow by `growth` - 1 per
/// length, as in limit_growth(). All small sizes together take at most a third of the vertices:
/// where they would take more, the smallest ones are made longer.
SmallFeatures find_small_features(const SurfaceInput& input, double spacing, double growth);

}  // namespace geolloyd
