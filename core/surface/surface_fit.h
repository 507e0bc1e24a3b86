#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/surface/surface_input.h"

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
/// distance to the remesh is least (quadrics, Garland and Heckbert 1997, shared among the corners
/// of a triangle): vertices on a curved surface leave all chords on one side of it. `labels` tell
/// the vertex of the remesh that each vertex of `input.fine` belongs to. A vertex with `stays` does
/// not move, one between two of `feature_edges` (as in SurfaceRemesh) not along them, and all others
/// along their normals alone. They move only where no angle gets smaller than the smallest one was, less 2
/// degrees, and no triangle turns by more than 30 degrees. Leaves the remesh as it is where sum or
/// largest distance would grow.
FitResult fit_to_surface(const SurfaceInput& input, std::span<const RegionId> labels,
                         std::span<const std::uint8_t> stays,
                         std::span<const std::array<VertexId, 2>> feature_edges, Mesh& remesh,
                         Executor& executor = sequential());

}  // namespace geolloyd
