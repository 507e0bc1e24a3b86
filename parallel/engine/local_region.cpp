#include "parallel/engine/local_region.h"

#include "parallel/threads/atomic_key.h"

namespace geolloyd {

void copy_region(const Graph& graph, const std::vector<Key>& keys, std::span<const NodeId> nodes,
                 std::vector<NodeId>& local_of, LocalRegion& local) {
  const RegionId region = region_of(load_key(keys[nodes.front()]));
  local.node.assign(nodes.begin(), nodes.end());
  local.partition.key.clear();
  local.partition.parent.resize(nodes.size());
  local.graph.mass.clear();
  ArcId most_arcs_here = 0;
  for (NodeId i = 0; i < nodes.size(); ++i) {
    const NodeId v = nodes[i];
    local_of[v] = i;
    local.partition.key.push_back(make_key(distance_of(load_key(keys[v])), 0));
    local.graph.mass.push_back(graph.mass[v]);
    most_arcs_here += graph.first_arc[v + 1] - graph.first_arc[v];
  }

  local.graph.first_arc.resize(nodes.size() + 1);
  local.graph.target.resize(most_arcs_here);
  local.graph.length.resize(most_arcs_here);
  ArcId next = 0;
  for (NodeId i = 0; i < nodes.size(); ++i) {
    local.graph.first_arc[i] = next;
    for (ArcId a = graph.first_arc[nodes[i]]; a < graph.first_arc[nodes[i] + 1]; ++a) {
      const NodeId u = graph.target[a];
      if (region_of(load_key(keys[u])) != region) continue;
      local.graph.target[next] = local_of[u];
      local.graph.length[next] = graph.length[a];
      ++next;
    }
  }
  local.graph.first_arc[nodes.size()] = next;
  local.graph.target.resize(next);
  local.graph.length.resize(next);
}

}  // namespace geolloyd
