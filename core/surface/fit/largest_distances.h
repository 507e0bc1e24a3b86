#pragma once

#include <span>
#include <vector>

#include "core/surface/substrate/surface_input.h"

namespace geolloyd {

/// Per vertex of a remesh, unit frame: how far vertices of the surface are from the triangles
/// there, at most. Of many, every so many are looked at, and all of `always`. `labels` are those of
/// fit_to_surface().
std::vector<double> largest_distances(const SurfaceInput& input, std::span<const RegionId> labels,
                                      std::span<const VertexId> always, const Mesh& remesh,
                                      Executor& executor = sequential());

}  // namespace geolloyd
