#pragma once

#include <span>
#include <vector>

#include "core/surface/flips/gliding_remesh.h"

namespace geolloyd {

/// Labels of the vertices of `fine` after some vertices of a remesh (ascending) have moved. What
/// belonged to one goes to those next to it, and where it is now it gets what is nearer to it than
/// to its neighbours: one vertex at least, if a neighbour has two.
void relabel_moved(const FineMesh& fine, const GlidingRemesh& remesh,
                   std::span<const VertexId> moved, std::vector<RegionId>& labels);

}  // namespace geolloyd
