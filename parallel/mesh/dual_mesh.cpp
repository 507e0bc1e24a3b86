#include "parallel/mesh/dual_mesh.h"

#include "core/remesh/dual_mesh_on.h"
#include "parallel/threads/primitives.h"

namespace geolloyd {

DualMesh make_dual(Scheduler& scheduler, const RegionSurface& surface) {
  return make_dual(surface, scan_surface_on(scheduler, surface));
}

}  // namespace geolloyd
