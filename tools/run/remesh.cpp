#include "tools/run/remesh.h"

#include "tools/evaluation/ground_truth.h"
#include "tools/system/interrupt.h"

namespace geolloyd {

GraphRemesh make_remesh(const RemeshInput& input, const RemeshRequest& request,
                        Scheduler& scheduler) {
  GraphRemeshOptions options;
  options.manifold = request.manifold;
  options.keep_going = [] { return !interrupted(); };
  if (request.vertices == RemeshVertices::centroids) {
    options.sites = [&](const std::vector<NodeId>& seeds, const Partition& partition) {
      return make_ground_truth(scheduler, input.mesh, input.mesh_graph, partition, seeds)
          .surface_centroid;
    };
  }
  return make_remesh(input, options);
}

}  // namespace geolloyd
