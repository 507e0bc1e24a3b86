#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/dual/dual_mesh.h"
#include "core/dual/region_surface.h"
#include "core/mesh/mesh.h"

namespace geolloyd {

/// Where the vertices of a dual could stand.
struct PlaceChoices {
  const std::vector<Vec3>& site;                        ///< per region
  std::vector<std::pair<RegionId, VertexId>> boundary;  ///< vertices on the boundary; ascending
  std::vector<std::uint8_t> is_outer;                   ///< per region: reaches the boundary
  std::vector<std::uint8_t> is_at_turn;                 ///< per region: stands where it turns
};

/// The second half of place_dual (dual_places.h): moves vertices to where fewer flaws are left by
/// it: to the site, to another vertex of the boundary, or, where neither helps, to another point of
/// the region. A flaw is a triangle that is turned over, or lower than a hundredth of its longest
/// edge, or a place of several vertices; no low triangle is mended by one that is turned over or
/// without area. A triangle starts a move if all its vertices are on the
/// boundary, or if they are in one line. Vertices at turns of the boundary move last. Vertices of
/// more than 256 triangles stay.
void repair_places(const Mesh& mesh, const RegionSurface& surface, const DualMesh& dual,
                   const PlaceChoices& choices, std::vector<Vec3>& place);

/// Flatness (mesh_measure.h) of a triangle of the dual; negative where it faces away from the
/// surface at the corner it stands for.
double signed_flatness(const Mesh& mesh, const RegionSurface& surface, const DualMesh& dual,
                       std::size_t triangle, const std::vector<Vec3>& place);

}  // namespace geolloyd
