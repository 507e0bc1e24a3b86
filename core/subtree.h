#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/graph.h"
#include "core/partition.h"

namespace geolloyd {

/// Sums over each node's subtree of the forest, the node itself included. Exact: distances are
/// below 2^31, masses below 2^32, and there are fewer than 2^30 nodes.
struct SubtreeSums {
  std::vector<std::uint64_t> cost;  ///< per node: sum of distances, ticks
  std::vector<std::uint64_t> mass;  ///< per node: sum of masses, ticks
};

/// Sums of `nodes`, which hold whole trees in an order where parents come before their children:
/// walked from its end, each node's sums are complete when they are pushed to its parent.
void sum_subtrees(const Graph& graph, const Partition& partition, std::span<const NodeId> nodes,
                  SubtreeSums& sums);

}  // namespace geolloyd
