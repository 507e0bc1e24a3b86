#pragma once

#include "core/mesh_graph.h"
#include "parallel/scheduler.h"

namespace geolloyd {

/// The twin of core's: the same bytes.
MeshGraph make_mesh_graph(Scheduler& scheduler, const Mesh& mesh, const MeshEdges& edges,
                          const MeshGraphOptions& options);

}  // namespace geolloyd
