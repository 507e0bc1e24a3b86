#include "geolloyd/remesh.h"

#include <string>
#include <utility>

#include "core/library/tessellated_graph.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/properties.h"
#include "core/mesh/property_mixture.h"
#include "core/remesh/remesh.h"
#include "core/surface/surface_engine.h"
#include "core/surface/surface_remesh.h"
#include "geolloyd/errors.h"

namespace geolloyd {

Remesh remesh(const Mesh& mesh, const Tessellation& tessellation, const RemeshOptions& options,
              Runtime& runtime) {
  const TessellatedGraph& tessellated = internals_of(tessellation, mesh);
  const auto engine = runtime.make_engine(tessellated.mesh_graph.graph);
  GraphRemeshOptions graph_options;
  graph_options.manifold = options.manifold;
  graph_options.keep_going = options.keep_going;
  GraphRemesh made = make_remesh({mesh, tessellated.mesh_graph, tessellated.relaxation.seeds,
                                  tessellated.relaxation.partition, *engine, runtime.executor()},
                                 graph_options);
  Remesh result;
  result.is_manifold = made.is_manifold();
  result.has_input_topology = made.has_input_topology();
  result.is_input_manifold = made.input_topology.is_manifold();
  for (const NodeId seed : made.seeds) {
    result.seeds.push_back(tessellated.mesh_graph.input_id[seed]);
  }
  result.seeds_added = made.seeds_added;
  result.interrupted = made.interrupted;
  result.violations_left = made.violations_left.size();
  result.flipped = made.flipped;
  result.flat = made.flat;
  result.folds = made.folds;
  result.mesh = std::move(made.mesh);
  return result;
}

SurfaceRemesh remesh_surface(const Mesh& mesh, const SurfaceRemeshOptions& options,
                             Runtime& runtime) {
  validate(mesh);
  const MeshEdges edges = find_edges(mesh, runtime.executor());
  SurfaceRemeshOptions checked = options;
  checked.field = checked_field(options.field, mesh.vertex_count());
  return make_surface_remesh(
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
