#include "core/voronoi/subtree.h"

namespace geolloyd {

void sum_subtrees(const Graph& graph, const Partition& partition, std::span<const NodeId> nodes,
                  SubtreeSums& sums) {
  for (const NodeId v : nodes) {
    sums.cost[v] = distance_of(partition.key[v]);
    sums.mass[v] = graph.mass[v];
  }
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const NodeId v = nodes[i];
    const NodeId parent = partition.parent[v];
    if (parent == no_id) continue;
    sums.cost[parent] += sums.cost[v];
    sums.mass[parent] += sums.mass[v];
  }
}

}  // namespace geolloyd
