#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/mesh/metric.h"
#include "core/surface/features/patches.h"
#include "core/surface/substrate/surface_input.h"

namespace geolloyd {

/// A vertex of a remesh that a fit has moved off its curve.
struct MovedCurveVertex {
  VertexId vertex;
  Vec3 on_curve;  ///< where it is closest to its curve, unit frame
};

/// Moves vertices of a remesh off the curves they are on, and along them, so that the edges along a
/// curve are closest to it in the mean square: vertices on it leave all chords on one side.
/// `labels` tell the vertex of the remesh that each vertex of `input.fine` belongs to.
///
/// Corners stay, and so does what is straight. Where a point of a curve would be farther than the
/// farthest one of it was, or a triangle be bad or pass through another (fit_guards.h, angles in
/// `metric`), the vertices there stay where they were. Returns those that moved, ascending.
std::vector<MovedCurveVertex> fit_to_curves(const SurfaceInput& input, const FeatureCurves& curves,
                                            std::span<const RegionId> labels,
                                            std::span<const Metric> metric, Mesh& remesh,
                                            Executor& executor = sequential());

}  // namespace geolloyd
