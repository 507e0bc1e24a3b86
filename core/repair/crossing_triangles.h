#pragma once

#include <array>

#include "core/base/vec3.h"

namespace geolloyd {

/// Whether two triangles cross: have a point in common beside the corners, or the edge, that they
/// share. Corners in the very same place are shared. So neighbours at an edge cross where one is
/// folded onto the other, and triangles that touch anywhere else do; those with the same three
/// corners cross, too. Exact (mesh/exact_signs.h). A triangle without area crosses nothing: its
/// edges are those of neighbours.
bool do_cross(const std::array<Vec3, 3>& first, const std::array<Vec3, 3>& second);

}  // namespace geolloyd
