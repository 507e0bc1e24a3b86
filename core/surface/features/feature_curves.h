#pragma once

#include <vector>

#include "core/surface/features/feature_curve.h"
#include "core/surface/substrate/surface_input.h"

namespace geolloyd {

/// Boundary, features and fixed vertices of a surface.
struct FeatureCurves {
  std::vector<FeatureCurve> curves;
  std::vector<VertexId> corners;   ///< ends of curves and fixed vertices, ascending
  std::vector<VertexId> vertices;  ///< on curves, and corners; each once, ascending
  std::vector<std::vector<VertexId>>
      subresolution_holes;      ///< loops too short for sites of their own
  std::vector<VertexId> loops;  ///< a vertex of each boundary loop, sub-resolution holes or not
};

/// Cuts boundary and features into curves at corners: where other than two of their edges meet,
/// where a vertex is fixed, and where they turn sharply (polyline.h). A boundary loop is a
/// sub-resolution hole, if `may_have_subresolution_holes`, where it is short, two of three even
/// places on it are less than 0.6 spacings apart, no feature or fixed vertex touches it, and its
/// part has room for some sites beside it.
FeatureCurves find_feature_curves(const SurfaceInput& input, double spacing,
                                  bool may_have_subresolution_holes);

}  // namespace geolloyd
