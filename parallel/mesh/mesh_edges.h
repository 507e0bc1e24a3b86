#pragma once

#include "core/mesh/mesh_edges.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {

/// The twin of core's: the same bytes.
MeshEdges find_edges(Scheduler& scheduler, const Mesh& mesh);

}  // namespace geolloyd
