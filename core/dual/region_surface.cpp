#include "core/dual/region_surface.h"

#include "core/mesh/mesh_measure.h"

namespace geolloyd {

Vec3 RegionSurface::position(const Mesh& mesh, PointId point) const {
  return point < vertex_count ? mesh.positions[point]
                              : barycentre(mesh, static_cast<TriangleId>(point - vertex_count));
}

}  // namespace geolloyd
