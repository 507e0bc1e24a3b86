#pragma once

#include <vector>

#include "core/dual/dual_mesh.h"
#include "core/dual/region_surface.h"
#include "core/mesh/mesh.h"

namespace geolloyd {

/// A position for each region's vertex of the dual. It is `site`, or in regions that reach the
/// boundary, so that the dual does not shrink from the boundary: the point of the boundary where
/// the boundary turns most, if it turns by more than 30 degrees, else the nearest to `site`; of
/// equals, the vertex with the smaller id.
///
/// Then no triangle shall have its vertices in one line, or be turned over, because all three went
/// to the boundary, and no two vertices shall be in one place: vertices go back to `site`, or to
/// another point of their region, where fewer such flaws are left by it. Where the region has no
/// better point, the flaws stay.
std::vector<Vec3> place_dual(const Mesh& mesh, const RegionSurface& surface, const DualMesh& dual,
                             const std::vector<Vec3>& site);

/// Triangles of the dual, so placed, that face away from the surface at the corner they stand for.
std::size_t count_flipped(const Mesh& mesh, const RegionSurface& surface, const DualMesh& dual,
                          const std::vector<Vec3>& place);

}  // namespace geolloyd
