#pragma once

#include <span>
#include <vector>

#include "core/graph/graph.h"
#include "core/voronoi/partition.h"

namespace geolloyd {

/// The parent of a reached node `v`: its smallest neighbour `u` of the same region with distance(u)
/// + length(u, v) = distance(v); none at a seed. A function of the settled keys alone, regions free
/// or locked, so no way of searching can change it.
inline NodeId derive_parent(const Graph& graph, const std::vector<Key>& keys, NodeId v) {
  const Key key = keys[v];
  const ArcId end = graph.first_arc[v + 1];
  for (ArcId a = graph.first_arc[v]; a < end; ++a) {
    // Equal keys are of one region, so `u` is reached too.
    if (along(keys[graph.target[a]], graph.length[a]) == key) return graph.target[a];
  }
  return no_id;
}

/// The same for each of `nodes`.
void derive_parents(const Graph& graph, const std::vector<Key>& keys, std::span<const NodeId> nodes,
                    std::vector<NodeId>& parents);

}  // namespace geolloyd
