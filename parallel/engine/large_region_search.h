#pragma once

#include <memory>
#include <vector>

#include "core/graph/graph.h"
#include "core/voronoi/energy.h"
#include "core/voronoi/partition.h"
#include "parallel/engine/delta_stepping.h"
#include "parallel/engine/neighbour_subtrees.h"
#include "parallel/engine/region_nodes.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {

/// Shortest distances over one large graph from one source at a time, by all threads or by one:
/// what lanes (simd_search.h) are to small regions. The bounds to start from are the same.
class LargeRegionSearch {
 public:
  LargeRegionSearch(Scheduler& scheduler, const Graph& graph);

  /// Distances from `source`, given those from `current` and its branches (neighbour_subtrees.h).
  void run(const Partition& partition, NodeId current, const BranchOf& branch_of, NodeId source);

  /// Parents of `partition` from its keys.
  void derive_parents(Partition& partition);
  /// The branches of `current`, and the subtree sums at its neighbours.
  void find_sums(NodeId current, const Partition& partition, BranchOf& branch_of,
                 SubtreeSums& sums);

  // Of the last run:
  [[nodiscard]] NodeId source() const { return source_; }
  [[nodiscard]] std::uint32_t distance(NodeId v) const { return distance_of(keys_[v]); }
  [[nodiscard]] Score score() const;
  void swap_keys(std::vector<Key>& keys) {
    keys_.swap(keys);
    source_ = no_id;
  }

 private:
  Scheduler& scheduler_;
  const Graph& graph_;
  DeltaStepping delta_stepping_;
  RegionNodes region_nodes_;  // one region: all nodes
  std::vector<RegionSlice> slices_;
  std::vector<Key> keys_;
  // To the source than to the current seed, by as much as these are apart.
  std::vector<NodeId> nearer_;
  std::vector<std::vector<NodeId>> nearer_of_worker_;
  NodeId source_ = no_id;
};

}  // namespace geolloyd
