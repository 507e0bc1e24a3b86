#pragma once

#include <span>
#include <vector>

#include "core/graph/graph.h"
#include "core/voronoi/energy.h"
#include "core/voronoi/partition.h"
#include "core/voronoi/subtree.h"

namespace geolloyd {

/// What deciding a seed's next node needs to know. Decisions are pure functions of it, so that
/// every engine shares them.
struct SeedMoveView {
  const Graph& graph;
  const Partition& partition;
  const SubtreeSums& sums;
  bool extended;  ///< heuristic of the extended mode
};

/// H(v) of neighbour `v` of `seed` in its region: cost(v) * mass(v), and in extended mode the same
/// of each neighbour of `v` whose parent is the seed.
Uint128 heuristic(const SeedMoveView& view, NodeId seed, NodeId v);

/// The neighbour of `seed` in its region with the largest heuristic, the smallest node of equals;
/// no_id where it has none.
NodeId greedy_candidate(const SeedMoveView& view, NodeId seed);

/// Of the neighbours of `seed` in its region that have a score, the one with the lowest if that is
/// below the seed's own, the smallest node of equals; else no_id. `score` holds one per node.
NodeId lower_neighbour(const Graph& graph, const std::vector<Key>& keys,
                       std::span<const Score> score, NodeId seed);

/// Where the precise phase moves `seed`: to its lower_neighbour if it has one; else of the
/// neighbours in its region never scored to that with the largest heuristic, the smallest node of
/// equals; else no_id, the seed stays.
NodeId precise_candidate(const SeedMoveView& view, std::span<const Score> score, NodeId seed);

}  // namespace geolloyd
