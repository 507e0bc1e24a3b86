#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/graph/graph.h"
#include "core/lloyd/engine.h"
#include "core/voronoi/partition.h"
#include "core/voronoi/subtree.h"
#include "parallel/engine/delta_stepping.h"
#include "parallel/engine/neighbour_subtrees.h"
#include "parallel/engine/parallel_engine.h"
#include "parallel/engine/region_nodes.h"
#include "parallel/engine/region_totals.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {

/// The partition, regions free, of seeds that move from time to time, or become more, and what
/// depends on it region by region. Only regions in which something changed are gone through
/// again.
class IncrementalPartition {
 public:
  IncrementalPartition(Scheduler& scheduler, const Graph& graph, Frontier frontier,
                       KernelSeconds& seconds);

  /// Finds the partition of `seeds` with its parents, the nodes of its regions and their totals.
  void update(std::span<const NodeId> seeds);
  /// Finds the subtree sums at the neighbours of the seeds, those of the last update().
  /// Returns the regions in which they were found anew.
  std::vector<RegionId> update_sums();
  /// Has the next update_sums() find all of them.
  void forget_sums() { has_sums_.assign(has_sums_.size(), 0); }

  [[nodiscard]] const Partition& partition() const { return partition_; }
  [[nodiscard]] const RegionNodes& region_nodes() const { return region_nodes_; }
  [[nodiscard]] const RegionTotals& totals() const { return totals_; }
  [[nodiscard]] const SubtreeSums& sums() const { return sums_; }
  /// Sum over all nodes (fingerprint.h).
  [[nodiscard]] std::uint64_t digest_of_nodes() const;

  /// For somebody to move seeds within their regions, and to set the keys of these regions to the
  /// distances within them from there: first forget(), so that the next update() begins from
  /// scratch if that comes to no end, then, when it has, moved_to(), so that it need not.
  /// Returns whether the keys were to be trusted so far.
  bool forget() { return std::exchange(has_partition_, false); }
  [[nodiscard]] std::vector<Key>& keys() { return partition_.key; }
  void moved_to(std::span<const NodeId> seeds);

 private:
  using Flags = std::vector<std::uint8_t>;  // per region

  [[nodiscard]] bool can_repair(std::span<const NodeId> seeds) const;
  void search_from_scratch(std::span<const NodeId> seeds);
  void sum_unreached();
  [[nodiscard]] bool search_from_last(std::span<const NodeId> seeds);
  void shift_keys(std::span<const RegionId> moved, std::span<const NodeId> seeds);
  void vacate(std::span<const RegionId> regions);
  [[nodiscard]] bool is_vacant(std::span<const RegionId> regions) const;
  void plant(RegionId region, NodeId seed);
  void add_regions(std::size_t count);
  void derive_changed();

  Scheduler& scheduler_;
  const Graph& graph_;
  Frontier frontier_;
  DeltaStepping delta_stepping_;
  KernelSeconds& seconds_;

  bool has_partition_ = false;
  std::vector<NodeId> seeds_;  // that the keys belong to
  Partition partition_;
  RegionNodes region_nodes_;
  RegionTotals totals_;
  std::uint64_t digest_of_unreached_ = 0;
  Flags is_changed_;  // since the last update, in its parents or totals
  Flags has_sums_;
  BranchOf branch_of_;  // of regions that have sums
  SubtreeSums sums_;
};

}  // namespace geolloyd
