#pragma once

#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/base/vec3.h"

namespace geolloyd {

/// Indices of `positions` along a Morton (Z-order) curve through their bounding cube, 21 bits an
/// axis; equal cells in order of index. What is near in space comes to lie near in memory.
std::vector<std::uint32_t> spatial_order(std::span<const Vec3> positions);

}  // namespace geolloyd
