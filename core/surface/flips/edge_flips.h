#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/mesh/metric.h"
#include "geolloyd/mesh.h"

namespace geolloyd {

/// Flips edges of a manifold, one after the other, where that makes the smallest angle of the two
/// triangles larger (Lawson 1977). Edges at which triangles meet at more than 30 degrees, boundary
/// edges, edges whose flip would make one that is there already, and those of `kept` (each
/// ascending; ascending) are not flipped. So topology and creases are preserved. Returns how many
/// it flipped. Angles are those in `metric`, of each vertex, if there is one.
std::size_t flip_edges(Mesh& mesh, std::span<const std::array<VertexId, 2>> kept = {},
                       std::span<const Metric> metric = {});

}  // namespace geolloyd
