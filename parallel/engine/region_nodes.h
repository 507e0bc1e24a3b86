#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/voronoi/partition.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {

/// The nodes of each region, ascending. Nodes that no seed reaches are in none.
struct RegionNodes {
  std::vector<NodeId> first{0};  ///< per region, and one more: into `node`
  std::vector<NodeId> node;

  [[nodiscard]] std::span<const NodeId> of(RegionId region) const {
    return {node.data() + first[region], node.data() + first[region + 1]};
  }
};

/// Some nodes of one region: large regions are cut, so that several threads can share one.
struct RegionSlice {
  RegionId region;
  NodeId begin;  ///< into RegionNodes::node
  NodeId end;
};

/// Sorts the nodes by region (counting, stable). Reuses the memory of `region_nodes`.
void find_region_nodes(Scheduler& scheduler, std::span<const Key> keys, std::size_t regions,
                       RegionNodes& region_nodes);

std::span<const NodeId> nodes_of(const RegionNodes& region_nodes, const RegionSlice& slice);

/// Whether the slice is all of its region.
bool is_whole(const RegionNodes& region_nodes, const RegionSlice& slice);

/// How many of them make a task worth giving to another thread.
std::size_t grain_of(std::span<const RegionSlice> slices);

/// The slices of those `regions`, in their order.
std::vector<RegionSlice> cut_into_slices(const RegionNodes& region_nodes,
                                         std::span<const RegionId> regions);

}  // namespace geolloyd
