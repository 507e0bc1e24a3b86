#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/substrate/surface_input.h"

namespace geolloyd {

/// Makes a fitted remesh more regular: irregular vertices glide by flips of edges until they meet
/// others and both are gone (glide_paths.h), and vertices move from where one is too many to where
/// one is missing (vertex_moves.h), wherever that pays (glide_trial.h). The first `held`
/// vertices stay, and so do edges of `kept` (each ascending; ascending) and the topology. Nothing
/// changes about vertices that are `barred` (per vertex, not 0). `labels` tell the vertex of the
/// remesh that each vertex of `input.fine` belongs to; those about vertices that move change.
/// Returns how many paths were taken and vertices moved.
///
/// The result of glides is that of one vertex after the other, on any number of threads. Some are
/// tried at once; one is tried anew where an earlier one has changed what it saw.
std::size_t glide_irregular(const SurfaceInput& input, std::vector<RegionId>& labels,
                            std::size_t held, std::span<const std::array<VertexId, 2>> kept,
                            std::span<const std::uint8_t> barred, Mesh& remesh,
                            Executor& executor = sequential());

}  // namespace geolloyd
