#include "core/graph/components.h"

#include "core/base/buffer.h"

namespace geolloyd {

Components connected_components(const Graph& graph) {
  constexpr std::size_t while_ahead = 12;
  Components result;
  result.component_of = huge_vector<std::uint32_t>(graph.node_count(), no_id);
  result.first_in.assign(1, 0);
  // Every neighbour is written behind those reached so far, and counts if it is new: a branch would
  // be guessed wrong once per node.
  Buffer<NodeId> reached(graph.node_count() + 1);
  NodeId size = 0;
  for (NodeId root = 0; root < graph.node_count(); ++root) {
    if (result.component_of[root] != no_id) continue;
    const auto component = static_cast<std::uint32_t>(result.first_in.size() - 1);
    result.component_of[root] = component;
    reached[size++] = root;
    for (NodeId i = result.first_in.back(); i < size; ++i) {
      if (i + while_ahead < size) {
        __builtin_prefetch(graph.neighbours(reached[i + while_ahead]).data());
      }
      for (const NodeId u : graph.neighbours(reached[i])) {
        reached[size] = u;
        size += result.component_of[u] == no_id ? 1 : 0;
        result.component_of[u] = component;
      }
    }
    result.first_in.push_back(size);
  }

  std::vector<NodeId> next(result.first_in.begin(), result.first_in.end() - 1);
  result.node = huge_vector<NodeId>(graph.node_count());
  for (NodeId v = 0; v < graph.node_count(); ++v) {
    result.node[next[result.component_of[v]]++] = v;
  }
  return result;
}

}  // namespace geolloyd
