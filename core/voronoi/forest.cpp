#include "core/voronoi/forest.h"

namespace geolloyd {

void derive_parents(const Graph& graph, const std::vector<Key>& keys, std::span<const NodeId> nodes,
                    std::vector<NodeId>& parents) {
  for (const NodeId v : nodes) parents[v] = derive_parent(graph, keys, v);
}

}  // namespace geolloyd
