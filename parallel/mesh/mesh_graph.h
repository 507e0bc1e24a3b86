#pragma once

#include "core/graph/mesh_graph.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {

/// The twin of core's: the same bytes.
MeshGraph make_mesh_graph(Scheduler& scheduler, const Mesh& mesh, const MeshEdges& edges,
                          const MeshGraphOptions& options);

}  // namespace geolloyd
