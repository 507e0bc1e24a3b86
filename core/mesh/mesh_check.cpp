#include "core/mesh/mesh_check.h"

#include "core/mesh/mesh_check_on.h"

namespace geolloyd {

MeshFacts check_mesh(const Mesh& mesh, const MeshEdges& edges) {
  Sequential one;
  return check_mesh_on(one, mesh, edges);
}

}  // namespace geolloyd
