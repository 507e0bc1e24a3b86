#pragma once

#include <cstdint>
#include <vector>

#include "core/base/executor.h"
#include "core/dual/region_surface.h"

namespace geolloyd {

/// What is to be known of all points and triangles of a surface before its dual is made.
struct SurfaceScan {
  /// Per region: twice the Euler characteristic, an edge within it counting half for each of its
  /// triangles.
  std::vector<std::int64_t> doubled_euler;
  std::vector<std::uint32_t> borders;  ///< triangles with several regions, ascending
};

SurfaceScan scan_surface(const RegionSurface& surface, Executor& executor);

}  // namespace geolloyd
