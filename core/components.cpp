#include "core/components.h"

namespace geolloyd {

Components connected_components(const Graph& graph) {
  Components result;
  result.component_of.assign(graph.node_count(), no_id);
  std::vector<NodeId> sizes;
  std::vector<NodeId> pending;
  for (NodeId root = 0; root < graph.node_count(); ++root) {
    if (result.component_of[root] != no_id) continue;
    const auto component = static_cast<std::uint32_t>(sizes.size());
    sizes.push_back(0);
    result.component_of[root] = component;
    pending.push_back(root);
    while (!pending.empty()) {
      const NodeId v = pending.back();
      pending.pop_back();
      ++sizes.back();
      for (const NodeId u : graph.neighbours(v)) {
        if (result.component_of[u] != no_id) continue;
        result.component_of[u] = component;
        pending.push_back(u);
      }
    }
  }

  result.first_in.assign(1, 0);
  for (const NodeId size : sizes) result.first_in.push_back(result.first_in.back() + size);
  std::vector<NodeId> next(result.first_in.begin(), result.first_in.end() - 1);
  result.node.resize(graph.node_count());
  for (NodeId v = 0; v < graph.node_count(); ++v) {
    result.node[next[result.component_of[v]]++] = v;
  }
  return result;
}

}  // namespace geolloyd
