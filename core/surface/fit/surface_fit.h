#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/surface/substrate/surface_input.h"

namespace geolloyd {

/// How far the samples of a surface are from a remesh, unit frame.
struct FitError {
  double mean_square = 0;  ///< weighted by area
  double largest = 0;
};

struct FitResult {
  FitError before;
  FitError after;
  double negligible = 0;       ///< a distance: a thousandth of a triangle's side
  std::size_t moved = 0;       ///< vertices
  std::vector<double> far_at;  ///< per vertex: the largest distance at its triangles, after
};

struct FitEffort {
  int rounds = 8;
  /// Asked after each iteration, if there is one. After a no, what has been reached is the result.
  std::function<bool()> keep_going = {};
};

/// Moves vertices of a remesh off the surface, and along it, so that the remesh is closer to the
/// surface and its triangles are more regular: vertices on a curved surface leave all chords on one
/// side of it. What is made least is fit_functional.h's sum of distances and strain. `labels` tell
/// the vertex of the remesh that each vertex of `input.fine` belongs to.
///
/// The first `held` vertices are fixed. Where a triangle would turn by more than 75 degrees, a
/// vertex rise by three fifths of a side, an angle would be smaller than the smallest one was less
/// 2 degrees, a point of the surface would be farther than the farthest one was, or triangles would
/// pass through each other and none did, the vertices there stay where they were, and the others
/// move. If the mean of square distances would grow,
/// distances count eight times as much; if it still would, nothing moves. Negligible distances may
/// grow, though, as where all is plane. Strain and angles are those in `metric`, of each vertex of
/// the remesh, if there is one.
FitResult fit_to_surface(const SurfaceInput& input, std::span<const RegionId> labels,
                         std::size_t held, std::span<const Metric> metric, Mesh& remesh,
                         Executor& executor = sequential(), const FitEffort& effort = {});

}  // namespace geolloyd
