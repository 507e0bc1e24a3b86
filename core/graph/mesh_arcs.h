#pragma once

#include <cstdint>

#include "core/base/buffer.h"
#include "core/base/executor.h"
#include "core/graph/mesh_graph.h"

namespace geolloyd {

/// The arcs of a mesh graph whose nodes have been numbered (mesh_graph.h). There may be several
/// between the same two nodes. Throws InvalidInput where there are more than fit.
Buffer<UndirectedArc> find_arcs(const Mesh& mesh, const MeshEdges& edges,
                                const MeshGraphOptions& options, const MeshGraph& numbered,
                                Executor& executor);

}  // namespace geolloyd
