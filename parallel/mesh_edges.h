#pragma once

#include "core/mesh_edges.h"
#include "parallel/scheduler.h"

namespace geolloyd {

/// The twin of core's: the same bytes.
MeshEdges find_edges(Scheduler& scheduler, const Mesh& mesh);

}  // namespace geolloyd
