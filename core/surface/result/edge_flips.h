#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/mesh/metric.h"
#include "geolloyd/mesh.h"

namespace geolloyd {

/// Flips edges of a manifold, one after the other, where that makes the smallest angle of the two
/// triangles larger (Lawson 1977). Triangles that meet at more than 30 degrees, boundary edges, and
/// edges whose flip would make one that is there already stay. So the topology stays, and creases.
/// Returns how many it flipped.
/// `kept` (each ascending; ascending) are not flipped either. Angles are those in `metric`, of each
/// vertex, if there is one.
std::size_t flip_edges(Mesh& mesh, std::span<const std::array<VertexId, 2>> kept = {},
                       std::span<const Metric> metric = {});

}  // namespace geolloyd
