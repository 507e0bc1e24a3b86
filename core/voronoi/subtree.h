#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/graph/graph.h"
#include "core/voronoi/partition.h"

namespace geolloyd {

/// No sum of distances, nor of masses, is larger, however many nodes it is over.
inline constexpr Uint128 most_cost = Uint128{most_nodes} * most_distance;
inline constexpr Uint128 most_subtree_mass = Uint128{most_nodes} * most_mass;
static_assert(most_cost <= std::numeric_limits<std::uint64_t>::max());
static_assert(most_subtree_mass <= std::numeric_limits<std::uint64_t>::max());

/// Sums over each node's subtree of the forest, the node itself included. Exact.
struct SubtreeSums {
  std::vector<std::uint64_t> cost;  ///< per node: sum of distances, ticks
  std::vector<std::uint64_t> mass;  ///< per node: sum of masses, ticks
};

/// Sums of `nodes`, which hold whole trees in an order where parents come before their children:
/// walked from its end, each node's sums are complete when they are pushed to its parent.
void sum_subtrees(const Graph& graph, const Partition& partition, std::span<const NodeId> nodes,
                  SubtreeSums& sums);

}  // namespace geolloyd
