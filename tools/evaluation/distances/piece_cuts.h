#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tools/evaluation/distances/triangle_tree.h"

namespace geolloyd {

/// Part of a triangle, and a triangle of another surface.
struct SurfacePiece {
  TriangleCorners corner;
  std::uint32_t near = 0;   ///< of the other surface: the closest one to all of the piece
  std::uint32_t depth = 0;  ///< how many cuts made it
};

/// Cuts a piece into two or three, of which more are likely to lie above one triangle of the other
/// surface each: in halves while it is much longer than `near`, else along the walls above the
/// edges of `near`, or in halves where no wall runs through it. TriangleCorners within `slack` of a
/// wall are on it. Adds the pieces, and their corners that are new.
void cut(const SurfacePiece& piece, const TriangleCorners& near, double slack,
         std::vector<SurfacePiece>& pieces, std::vector<Vec3>& corners);

}  // namespace geolloyd
