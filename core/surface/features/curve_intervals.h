#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/surface/features/feature_curve.h"

namespace geolloyd {

/// Finds out how many sites each curve is to have: fills in `of_chords`, `least_intervals` and the
/// steps at the ends. No two edges of a remesh join the same corners, chords follow features that
/// curve, and first sites stand back from acute corners. `features` are ascending.
void find_curve_intervals(const FineMesh& mesh, std::span<const std::array<VertexId, 2>> features,
                          double spacing, std::vector<FeatureCurve>& curves);

}  // namespace geolloyd
