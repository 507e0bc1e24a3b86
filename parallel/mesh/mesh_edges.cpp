#include "parallel/mesh/mesh_edges.h"

#include "core/mesh/mesh_edges_on.h"
#include "parallel/threads/primitives.h"

namespace geolloyd {

MeshEdges find_edges(Scheduler& scheduler, const Mesh& mesh) {
  return scheduler.threads() == 1 ? find_edges(mesh) : find_edges_on(scheduler, mesh);
}

}  // namespace geolloyd
