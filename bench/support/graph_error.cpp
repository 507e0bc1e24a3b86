#include "bench/support/graph_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/random.h"
#include "core/voronoi/dijkstra.h"

namespace geolloyd {

std::vector<double> graph_distances(const Graph& graph, NodeId source) {
  IndexedHeap heap(graph.node_count());
  std::vector<Key> keys;
  std::vector<NodeId> settled;
  search_free(graph, {&source, 1}, heap, keys, settled);
  std::vector<double> distances(graph.node_count(), std::numeric_limits<double>::infinity());
  for (const NodeId v : settled) distances[v] = distance_of(keys[v]) * graph.tick_length;
  return distances;
}

GraphError measure_graph_error(const MeshGraph& mesh_graph, std::size_t sources,
                               std::uint64_t random_seed, double nearest,
                               const ExactDistance& exact) {
  const Graph& graph = mesh_graph.graph;
  GraphError error;
  error.smallest = std::numeric_limits<double>::infinity();
  error.largest = -error.smallest;
  double sum = 0;
  double squares = 0;
  for (std::uint64_t n = 0; n < sources; ++n) {
    const auto source = static_cast<NodeId>(random_below(random_seed, n, graph.node_count()));
    const std::vector<double> distances = graph_distances(graph, source);
    for (NodeId v = 0; v < graph.node_count(); ++v) {
      const double length = exact(mesh_graph.position[source], mesh_graph.position[v]);
      if (length < nearest || !std::isfinite(distances[v])) continue;
      const double relative = (distances[v] - length) / length;
      ++error.pairs;
      sum += relative;
      squares += relative * relative;
      error.smallest = std::min(error.smallest, relative);
      error.largest = std::max(error.largest, relative);
    }
  }
  if (error.pairs == 0) return {};
  const auto pairs = static_cast<double>(error.pairs);
  error.mean = sum / pairs;
  error.rms = std::sqrt(squares / pairs);
  return error;
}

}  // namespace geolloyd
