#pragma once

#include <array>
#include <vector>

#include "core/mesh/mesh.h"

namespace geolloyd::creature_blocks {

// The animal of creature() in blocks: x forward, y to the left, z up; block (x, y, z) fills the
// unit cube from that corner on. The mirror plane is y = 0.
inline constexpr int full_length = 28;
inline constexpr int half_width = 3;
inline constexpr int height = 22;

/// False everywhere outside the box that the constants span.
bool is_solid(int x, int y, int z);

struct QuadMesh {
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 4>> quads;  ///< counter-clockwise seen from outside
};

/// The faces between a block and no block: closed, manifold, of genus 0.
QuadMesh surface();

}  // namespace geolloyd::creature_blocks
