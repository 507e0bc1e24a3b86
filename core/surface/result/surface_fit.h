#pragma once

#include <cstddef>
#include <span>

#include "core/surface/substrate/surface_input.h"

namespace geolloyd {

/// How far the samples of a surface are from a remesh, unit frame.
struct FitError {
  double sum_of_squares = 0;  ///< weighted by area
  double largest = 0;
};

struct FitResult {
  FitError before;
  FitError after;
  std::size_t moved = 0;  ///< vertices
};

/// Moves vertices of a remesh off the surface so that the sum over the surface of the square
/// distance to the remesh is least (planes of triangles, as in Garland and Heckbert 1997, shared
/// among the corners): vertices on a curved surface leave all chords on one side of it. `labels`
/// tell the vertex of the remesh that each vertex of `input.fine` belongs to.
///
/// The first `held` vertices stay. The others move no farther along their normals than any point of
/// the surface about them was from the remesh, and sideways as reluctantly as it takes to keep the
/// mean quality of triangles within 0.0008 or, where the surface is too curved for that, 0.005. No
/// angle gets smaller than the smallest one was, less 2 degrees, and no triangle turns by more than
/// 30 degrees. Quality and angles are those in `metric`, of each vertex of the remesh, if there is
/// one. If the sum or the largest distance would grow, nothing moves.
FitResult fit_to_surface(const SurfaceInput& input, std::span<const RegionId> labels,
                         std::size_t held, std::span<const Metric> metric, Mesh& remesh,
                         Executor& executor = sequential());

}  // namespace geolloyd
