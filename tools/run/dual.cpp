#include "tools/run/dual.h"

#include "tools/evaluation/ground_truth.h"
#include "tools/system/interrupt.h"

namespace geolloyd {

GraphDual make_graph_dual(const GraphDualInput& input, const DualRequest& request,
                          Executor& executor) {
  GraphDualOptions options;
  options.manifold = request.manifold;
  options.keep_going = [] { return !interrupted(); };
  if (request.vertices == DualVertices::centroids) {
    options.sites = [&](const std::vector<NodeId>& seeds, const Partition& partition) {
      return make_ground_truth(executor, input.mesh, input.mesh_graph, partition, seeds)
          .surface_centroid;
    };
  }
  return make_graph_dual(input, options);
}

}  // namespace geolloyd
