#pragma once

#include <functional>
#include <vector>

#include "core/surface/creases/edge_angles.h"

namespace geolloyd {

/// How much there is of a curve.
struct CurveExtent {
  double length = 0;  // mesh units
  std::size_t edges = 0;

  void add(const CurveExtent& other) {
    length += other.length;
    edges += other.edges;
  }
};

/// Cuts off curves that end where nothing else is and for which `is_short` (of the sum of their
/// edges' extents) is true. What that leaves may end there in turn.
void cut_loose_ends(const EdgeAngles& angles, const std::function<CurveExtent(EdgeId)>& extent,
                    const std::function<bool(const CurveExtent&)>& is_short,
                    std::vector<EdgeId>& creases);

/// Cuts off what is within `reach` (mesh units) of a loose end and points elsewhere than the curve
/// before it, by 10 degrees and more. So ends an upright edge where a fillet smaller than edges
/// begins.
void cut_bent_tails(const EdgeAngles& angles, double reach, std::vector<EdgeId>& creases);

}  // namespace geolloyd
