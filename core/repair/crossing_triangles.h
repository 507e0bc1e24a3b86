#pragma once

#include <array>

#include "core/base/vec3.h"

namespace geolloyd {

/// Whether two triangles pass through each other, or overlap in one plane. Those that touch do not:
/// neighbours at an edge or a corner cross only where they have more in common.
bool do_cross(const std::array<Vec3, 3>& first, const std::array<Vec3, 3>& second);

}  // namespace geolloyd
