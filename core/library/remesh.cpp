#include "geolloyd/remesh.h"

#include <string>
#include <utility>

#include "core/course/remesh_course.h"
#include "core/library/tessellated_graph.h"
#include "core/mesh/mesh_edges.h"
#include "core/properties/properties.h"
#include "core/properties/property_mixture.h"
#include "geolloyd/errors.h"

namespace geolloyd {

Remesh remesh(const Mesh& mesh, const RemeshOptions& options, Runtime& runtime) {
  validate(mesh);
  MeshEdges edges = find_edges(mesh, runtime.executor());
  RemeshCourse course{mesh, edges, options, runtime};
  course.options.field = checked_field(options.field, mesh.vertex_count());
  course.release_edges = [&edges] { release_all_but_duplicates(edges); };
  return run(std::move(course)).remesh;
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
    mixtures.push_back(mixture_at(mesh.triangles, place));
  }
  return mix(of_vertices, mixtures, runtime.executor());
}

}  // namespace geolloyd
