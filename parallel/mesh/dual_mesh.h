#pragma once

#include "core/remesh/dual_mesh.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {

/// The twin of core's: the same bytes.
DualMesh make_dual(Scheduler& scheduler, const RegionSurface& surface);

}  // namespace geolloyd
