#include "parallel/mesh/mesh_graph.h"

#include "core/graph/mesh_graph_on.h"
#include "parallel/threads/primitives.h"

namespace geolloyd {

MeshGraph make_mesh_graph(Scheduler& scheduler, const Mesh& mesh, const MeshEdges& edges,
                          const MeshGraphOptions& options) {
  return scheduler.threads() == 1 ? make_mesh_graph(mesh, edges, options)
                                  : make_mesh_graph_on(scheduler, mesh, edges, options);
}

}  // namespace geolloyd
