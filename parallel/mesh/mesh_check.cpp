#include "parallel/mesh/mesh_check.h"

#include "core/mesh/mesh_check_on.h"
#include "parallel/threads/primitives.h"

namespace geolloyd {

MeshFacts check_mesh(Scheduler& scheduler, const Mesh& mesh, const MeshEdges& edges) {
  return scheduler.threads() == 1 ? check_mesh(mesh, edges) : check_mesh_on(scheduler, mesh, edges);
}

}  // namespace geolloyd
