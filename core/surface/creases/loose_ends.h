#pragma once

#include <functional>
#include <vector>

#include "core/surface/creases/edge_angles.h"

namespace geolloyd {

/// Cuts off curves that end where nothing else is and for which `is_short` (their length in mesh
/// units, and their number of edges) is true. What that leaves may end there in turn.
void cut_loose_ends(const EdgeAngles& angles,
                    const std::function<bool(double length, std::size_t edges)>& is_short,
                    std::vector<EdgeId>& creases);

}  // namespace geolloyd
