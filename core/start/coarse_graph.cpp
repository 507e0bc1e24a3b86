#include "core/start/coarse_graph.h"

namespace geolloyd {

Graph contract(const Graph& graph, const Partition& partition, std::size_t regions,
               Executor& executor) {
  const std::vector<Key>& key = partition.key;
  std::vector<UndirectedArc> arcs;
  for (NodeId v = 0; v < graph.node_count(); ++v) {
    for (ArcId a = graph.first_arc[v]; a < graph.first_arc[v + 1]; ++a) {
      const NodeId u = graph.target[a];
      if (u < v || same_region(key, u, v)) continue;
      const std::uint64_t ticks =
          std::uint64_t{distance_of(key[v])} + graph.length[a] + distance_of(key[u]);
      arcs.push_back(
          {region_of(key[v]), region_of(key[u]), static_cast<double>(ticks) * graph.tick_length});
    }
  }
  std::vector<double> masses(regions, 0);
  for (NodeId v = 0; v < graph.node_count(); ++v) {
    masses[region_of(key[v])] += graph.mass[v] * graph.tick_mass;
  }
  return make_graph(arcs, masses, executor);
}

}  // namespace geolloyd
