#pragma once

#include "core/mesh/mesh_check.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {

/// The twin of core's: the same bytes.
MeshFacts check_mesh(Scheduler& scheduler, const Mesh& mesh, const MeshEdges& edges);

}  // namespace geolloyd
