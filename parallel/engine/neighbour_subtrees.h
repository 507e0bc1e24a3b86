#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/graph/graph.h"
#include "core/voronoi/partition.h"
#include "core/voronoi/subtree.h"
#include "parallel/engine/region_nodes.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {

// To move a seed one needs the subtree sums of its neighbours only. So instead of adding up the
// forest node by node, each node is told its branch, and added to that: the nearest neighbour of
// the seed, in its region, among the node's ancestors and the node itself. Then branches that hang
// from other branches (a neighbour need not be a child) are added up. No order of nodes is needed.

/// Per node, the number of the seed's arc that leads to its branch; no_branch at the seed.
using BranchOf = std::vector<std::uint32_t>;
inline constexpr std::uint32_t no_branch = no_id;

struct BranchSum {
  std::uint64_t cost = 0;  ///< of distances, ticks
  std::uint64_t mass = 0;  ///< ticks

  BranchSum& operator+=(const BranchSum& other) {
    cost += other.cost;
    mass += other.mass;
    return *this;
  }
};

/// In turn, for a region: forgets the branches of `nodes`, which together are all of it; marks the
/// neighbours of the seed; adds `nodes`, again all in all, to `sums`, one per arc of the seed;
/// and sets `sums_at` the neighbours to their whole subtree sums. The first and third may be called
/// by several threads for different nodes at once.
void forget_branches(std::span<const NodeId> nodes, BranchOf& branch_of);
void mark_branches(const Graph& graph, const std::vector<Key>& keys, NodeId seed,
                   BranchOf& branch_of);
void add_to_branches(const Graph& graph, const Partition& partition, std::span<const NodeId> nodes,
                     BranchOf& branch_of, std::span<BranchSum> sums);
void add_up_branches(const Graph& graph, const Partition& partition, NodeId seed,
                     const BranchOf& branch_of, std::span<BranchSum> sums, SubtreeSums& sums_at);

/// All of that for a region of `nodes`; `sums` is room for work.
void find_branches(const Graph& graph, const Partition& partition, NodeId seed,
                   std::span<const NodeId> nodes, BranchOf& branch_of, std::vector<BranchSum>& sums,
                   SubtreeSums& sums_at);

/// All of that for the regions that `slices` make up, those of a region in a row.
void find_branches(Scheduler& scheduler, const Graph& graph, std::span<const NodeId> seeds,
                   const Partition& partition, const RegionNodes& region_nodes,
                   std::span<const RegionSlice> slices, BranchOf& branch_of, SubtreeSums& sums_at);

/// Per arc of `seed`: not 0 where that branch lies in the subtree of `top`; all 0 where `top` is no
/// neighbour of `seed`.
void find_branches_below(const Graph& graph, const Partition& partition, NodeId seed,
                         const BranchOf& branch_of, NodeId top, std::vector<std::uint8_t>& below);

/// A bound on a node's key once its seed has moved by `way` ticks: what lies in one of the branches
/// `below` the new place (none, where that is not known) is nearer by as much, the rest is farther
/// by that at most.
inline Key bound_after_move(Key key, std::uint32_t branch, const std::vector<std::uint8_t>& below,
                            std::uint32_t way) {
  const bool nearer = branch < below.size() && below[branch] != 0;
  return nearer ? key - make_key(way, 0) : bounded_along(key, way);
}

}  // namespace geolloyd
