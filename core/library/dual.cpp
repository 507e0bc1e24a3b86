#include "geolloyd/dual.h"

#include <utility>

#include "core/library/tessellated_graph.h"
#include "core/regions/graph_dual.h"

namespace geolloyd {

Dual dual(const Mesh& mesh, const Tessellation& tessellation, const DualOptions& options,
          Runtime& runtime) {
  const TessellatedGraph& tessellated = internals_of(tessellation, mesh);
  const auto engine = runtime.make_engine(tessellated.mesh_graph.graph);
  GraphDualOptions graph_options;
  graph_options.manifold = options.manifold;
  graph_options.keep_going = options.keep_going;
  GraphDual made = make_graph_dual({mesh, tessellated.mesh_graph, tessellated.relaxation.seeds,
                                    tessellated.relaxation.partition, *engine, runtime.executor()},
                                   graph_options);
  Dual result;
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
  result.self_intersections = std::move(made.self_intersections);
  result.mesh = std::move(made.mesh);
  return result;
}

}  // namespace geolloyd
