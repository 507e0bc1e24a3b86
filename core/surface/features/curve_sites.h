#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/surface/features/feature_curves.h"

namespace geolloyd {

/// First the corners, then the sites of each curve from end to end. Each has the label of a vertex,
/// at least.
struct CurveSites {
  std::vector<Vec3> sites;
  std::vector<RegionId> label;  ///< per vertex on curves: the nearest site along the curve
};

/// Spaces sites evenly along each curve, with chords about `spacing` long.
CurveSites place_curve_sites(const SurfaceInput& input, const FeatureCurves& curves,
                             double spacing);

/// Pairs of sites that are neighbours on a curve: ascending within, and each once.
std::vector<std::array<RegionId, 2>> neighbours_on_curves(const FeatureCurves& curves,
                                                          std::span<const RegionId> label);

}  // namespace geolloyd
