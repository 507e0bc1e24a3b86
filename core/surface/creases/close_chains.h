#pragma once

#include <vector>

#include "core/surface/creases/edge_angles.h"

namespace geolloyd {

/// The edges of a crease from one junction to the next.
using CreaseChain = std::vector<EdgeId>;

/// Of two chains along a strip narrower than `width` (mesh units), as along a chamfer, drops the
/// shorter, where it turns by less than 75 degrees: the other stands for both. Both sides of walls
/// and steps turn by more, and stay.
void drop_close_chains(const EdgeAngles& angles, double width, std::vector<CreaseChain>& chains);

}  // namespace geolloyd
