#pragma once

#include <vector>

#include "core/surface/features/patches.h"
#include "core/surface/sites/site_levels.h"

namespace geolloyd {

/// Takes a triangle out of a dual for each sub-resolution hole, which the dual has closed: the
/// nearest one whose vertices are not on a curve or another hole, in the same patch; of equals, the
/// first one. So the hole is as large as a triangle, and no triangle about it is thin. False where
/// there are not triangles enough; then none is taken out.
bool open_subresolution_holes(const DividedSurface& surface, const SurfaceSites& sites,
                              std::vector<Triangle>& triangles);

}  // namespace geolloyd
