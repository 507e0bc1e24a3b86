#include "tools/run/dual.h"

#include "tools/evaluation/attribute_transfer.h"
#include "tools/evaluation/ground_truth.h"
#include "tools/system/interrupt.h"

namespace geolloyd {

MadeDual make_dual(const PreparedInput& run, const std::vector<NodeId>& seeds,
                   const Partition& partition, Engine& engine, const DualRequest& request,
                   Executor& executor) {
  const Mesh& mesh = run.input.mesh();
  GraphDualOptions options;
  options.manifold = request.manifold;
  options.keep_going = [] { return !interrupted(); };
  if (request.vertices == DualVertices::centroids) {
    options.sites = [&](const std::vector<NodeId>& all, const Partition& regions) {
      return make_ground_truth(executor, mesh, run.mesh_graph, regions, all).surface_centroid;
    };
  }
  MadeDual made{
      geolloyd::make_dual(mesh, run, seeds, partition, engine, options, executor), {}, {}};
  if (request.quads) made.quads = pair_triangles(made.mesh, find_edges(made.mesh, executor));
  return made;
}

MadeDual make_whole_dual(const PreparedInput& run, const std::vector<NodeId>& seeds,
                         const Partition& partition, Engine& engine, const DualRequest& request,
                         Executor& executor) {
  MadeDual made = make_dual(run, seeds, partition, engine, request, executor);
  made.properties = transfer_properties(run.input.mesh(), run.input.loaded.properties,
                                        run.mesh_graph, made, executor);
  return made;
}

}  // namespace geolloyd
