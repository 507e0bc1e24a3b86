#pragma once

#include <array>
#include <vector>

#include "core/surface/flips/glide_patch.h"

namespace geolloyd {

/// Edges to flip one after the other.
using FlipPath = std::vector<std::array<VertexId, 2>>;

/// Paths of flips that start at the centre of a patch and lower the sum of squares of excess: an
/// irregular vertex, or a pair, glides through the remesh until it meets another one. No flip of a
/// path raises the sum. The shortest ones of those met first, shortest first.
std::vector<FlipPath> find_glide_paths(GlidePatch patch);

}  // namespace geolloyd
