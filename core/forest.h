#pragma once

#include <span>
#include <vector>

#include "core/graph.h"
#include "core/partition.h"

namespace geolloyd {

/// The parent of a reached node `v`: its smallest neighbour `u` of the same region with distance(u)
/// + length(u, v) = distance(v); none at a seed. A function of the settled keys alone, regions free
/// or locked, so no way of searching can change it.
NodeId derive_parent(const Graph& graph, const std::vector<Key>& keys, NodeId v);
void derive_parents(const Graph& graph, const std::vector<Key>& keys, std::span<const NodeId> nodes,
                    std::vector<NodeId>& parents);

}  // namespace geolloyd
