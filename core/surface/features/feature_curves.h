#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/substrate/surface_input.h"

namespace geolloyd {

/// A piece of the boundary or of a feature between two corners, or a loop without corners. Sites
/// on it are evenly spaced and stay where they are.
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
  /// Where site i of so many intervals is.
  [[nodiscard]] double place(std::size_t i, std::size_t intervals) const;
  /// Intervals with chords about `spacing` long, and no more than it has edges.
  [[nodiscard]] std::size_t intervals(double spacing) const;
};

/// Boundary, features and fixed vertices of a surface.
struct FeatureCurves {
  std::vector<FeatureCurve> curves;
  std::vector<VertexId> corners;   ///< ends of curves and fixed vertices, ascending
  std::vector<VertexId> vertices;  ///< on curves, and corners; each once, ascending
  std::vector<std::vector<VertexId>>
      subresolution_holes;      ///< loops too short for sites of their own
  std::vector<VertexId> loops;  ///< a vertex of each boundary loop, sub-resolution holes or not
};

/// A corner is where other than two edges of boundary and features meet, where a vertex is fixed,
/// and where a curve turns by more than 50 degrees within half a spacing to either side, or by 30
/// between straight sides. A boundary
/// loop is a sub-resolution hole, if `may_have_subresolution_holes`, where it is short, two of
/// three even places on it are less than 0.6 spacings apart, no feature or fixed vertex touches it,
/// and its part has room for some sites beside it.
FeatureCurves find_feature_curves(const SurfaceInput& input, double spacing,
                                  bool may_have_subresolution_holes);

/// First the corners, then the sites of each curve from end to end. Each has the label of a vertex,
/// at least.
struct CurveSites {
  std::vector<Vec3> sites;
  std::vector<RegionId> label;  ///< per vertex on curves: the nearest site along the curve
};

CurveSites place_curve_sites(const SurfaceInput& input, const FeatureCurves& curves,
                             double spacing);

/// Pairs of sites that are neighbours on a curve: ascending within, and each once.
std::vector<std::array<RegionId, 2>> neighbours_on_curves(const FeatureCurves& curves,
                                                          std::span<const RegionId> label);

}  // namespace geolloyd
