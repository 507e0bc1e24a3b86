#pragma once

#include "core/repair/mesh_under_repair.h"
#include "geolloyd/repair.h"

namespace geolloyd {

/// Leaves out components all of whose triangles are slivers, unless all are, and components each of
/// whose triangles has its corners in the places of a triangle of another component that stays.
/// Components with fewer triangles go first, later ones before earlier ones. The mesh is a
/// manifold.
void remove_loose_components(MeshUnderRepair& state, Repairs& repairs);

}  // namespace geolloyd
