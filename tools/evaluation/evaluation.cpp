#include "geolloyd/evaluation.h"

#include <cmath>
#include <utility>

#include "core/library/tessellated_graph.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_edges.h"
#include "geolloyd/errors.h"
#include "tools/evaluation/distances/closest_places.h"
#include "tools/evaluation/distances/distance_bounds.h"
#include "tools/evaluation/distances/surface_distance.h"
#include "tools/evaluation/ground_truth.h"
#include "tools/evaluation/tolerance_search.h"

namespace geolloyd {

Evaluation evaluate(const Mesh& mesh, const Tessellation& tessellation, Runtime& runtime) {
  const TessellatedGraph& tessellated = internals_of(tessellation, mesh);
  const MeshGraph& made = tessellated.mesh_graph;
  GroundTruth truth =
      make_ground_truth(runtime.executor(), mesh, made, tessellated.relaxation.partition,
                        tessellated.relaxation.seeds);
  Evaluation result;
  result.region.assign(made.node_of.size(), no_id);
  for (NodeId v = 0; v < truth.region.size(); ++v)
    result.region[made.input_id[v]] = truth.region[v];
  result.centroid = std::move(truth.surface_centroid);
  result.node_agreement = truth.node_agreement;
  result.area_agreement = truth.area_agreement;
  result.mean_distance_in_radii = truth.distance_in_radii.mean();
  result.energy = truth.energy;
  result.graph_energy = truth.graph_energy;
  result.energy_of_hexagonal_tiling = truth.hexagonal;
  return result;
}

SurfaceDistance measure_distance(const Mesh& first, const Mesh& second, std::size_t samples,
                                 Runtime& runtime) {
  validate(first);
  validate(second);
  if (samples == 0) throw InvalidInput("samples: at least 1");
  return measure_distance(runtime.executor(), first, second, samples);
}

SurfaceDistanceBounds certify_distance(const Mesh& first, const Mesh& second, double tolerance,
                                       Runtime& runtime) {
  validate(first);
  validate(second);
  if (!std::isfinite(tolerance) || tolerance < 0) {
    throw InvalidInput("tolerance: give a distance of at least 0");
  }
  return certify_distance(runtime.executor(), first, second, tolerance);
}

std::vector<SurfacePoint> closest_points(const Mesh& mesh, const std::vector<Vec3>& points,
                                         Runtime& runtime) {
  validate(mesh);
  validate_contents(Mesh{points, {}});
  return closest_places(mesh, points, runtime.executor());
}

ToleranceRemesh remesh_within(const Mesh& mesh, double tolerance, RemeshOptions options,
                              Runtime& runtime) {
  validate(mesh);
  if (options.vertex_count > 0 || options.edge_length > 0) {
    throw InvalidInput("tolerance: give no number of vertices and no edge length beside it");
  }
  options.field = checked_field(options.field, mesh.vertex_count());
  SizingOptions& sizing = options.sizing;
  const bool is_free = sizing.edge_lengths.empty() && sizing.densities.empty() &&
                       options.field.empty() && !(sizing.adapt > 0);
  if (is_free) sizing.equal_error = true;
  const MeshEdges edges = find_edges(mesh, runtime.executor());
  ToleranceSearch found = search_within(tolerance, {mesh, edges, std::move(options), runtime});
  return {std::move(found.best.remesh), found.bounds, std::move(found.trials)};
}

}  // namespace geolloyd
