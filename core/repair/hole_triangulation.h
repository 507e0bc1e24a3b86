#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"

namespace geolloyd {

/// A hole in a surface: corners in the order in which triangles that fill it are oriented like what
/// is around it. No two are in the same place.
struct HoleOutline {
  std::vector<Vec3> corners;
  std::vector<Vec3> normals;  ///< of the triangle beyond the edge from a corner to the next one
};

/// What a filling may not have.
struct HoleLimits {
  std::function<bool(std::uint32_t, std::uint32_t)> is_forbidden;  ///< an inner edge
  std::function<bool(const Triangle&)> is_blocked = {};            ///< a triangle; empty: none is
};

/// The triangles, of positions in the outline, that fill a hole and bend least: their largest turn
/// against each other and against what is around is as small as can be, then their area (Liepa
/// 2003, after Barequet and Sharir 1995).
/// Up to 48 corners, or 192 with blocked triangles; of larger holes, corners are cut off first, the
/// shortest new edge at a time.
/// Empty where none fills the hole without a sliver or a turn of 150 degrees and more.
std::vector<Triangle> triangulate_hole(const HoleOutline& outline, const HoleLimits& limits);

}  // namespace geolloyd
