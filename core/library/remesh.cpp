#include "geolloyd/remesh.h"

#include <string>
#include <utility>

#include "core/library/tessellated_graph.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/properties.h"
#include "core/mesh/property_mixture.h"
#include "core/surface/cells/surface_engine.h"
#include "core/surface/result/remesh.h"
#include "geolloyd/errors.h"

namespace geolloyd {

Remesh remesh(const Mesh& mesh, const RemeshOptions& options, Runtime& runtime) {
  validate(mesh);
  const MeshEdges edges = find_edges(mesh, runtime.executor());
  RemeshOptions checked = options;
  checked.field = checked_field(options.field, mesh.vertex_count());
  return make_remesh(
      mesh, edges, checked,
      [&runtime](const FineMesh& fine) { return runtime.make_surface_engine(fine); },
      runtime.executor());
}

std::vector<Property> values_at(const Mesh& mesh, const std::vector<Property>& of_vertices,
                                const std::vector<SurfacePoint>& places, Runtime& runtime) {
  validate_contents(mesh);
  validate(Properties{of_vertices, {}, {}}, mesh);
  std::vector<Mixture> mixtures;
  mixtures.reserve(places.size());
  for (const SurfacePoint& place : places) {
    if (place.triangle != no_id && place.triangle >= mesh.triangle_count()) {
      throw InvalidInput("place " + std::to_string(mixtures.size()) +
                         ": the mesh has no triangle " + std::to_string(place.triangle));
    }
    mixtures.push_back(mixture_at(mesh, place));
  }
  return mix(of_vertices, mixtures, runtime.executor());
}

}  // namespace geolloyd
