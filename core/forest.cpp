#include "core/forest.h"

namespace geolloyd {

NodeId derive_parent(const Graph& graph, const std::vector<Key>& keys, NodeId v) {
  for (ArcId a = graph.first_arc[v]; a < graph.first_arc[v + 1]; ++a) {
    const NodeId u = graph.target[a];
    if (keys[u] != unreached && along(keys[u], graph.length[a]) == keys[v]) return u;
  }
  return no_id;
}

void derive_parents(const Graph& graph, const std::vector<Key>& keys, std::span<const NodeId> nodes,
                    std::vector<NodeId>& parents) {
  for (const NodeId v : nodes) parents[v] = derive_parent(graph, keys, v);
}

}  // namespace geolloyd
