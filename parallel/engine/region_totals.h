#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/kernel_seconds.h"
#include "core/graph/graph.h"
#include "core/voronoi/energy.h"
#include "core/voronoi/partition.h"
#include "parallel/engine/region_nodes.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {

/// Per region, sums over its nodes. Exact, so the same in any order.
struct RegionTotals {
  std::vector<Score> score;
  std::vector<std::uint64_t> digest;  ///< of nodes (fingerprint.h)
};

/// Derives the parents of the nodes in `slices`, which make up whole regions, and the totals of
/// those regions, from their settled keys (forest.h, energy.h). Adds to `seconds` what each took.
void derive_parents_and_totals(Scheduler& scheduler, const Graph& graph,
                               const RegionNodes& region_nodes, std::span<const RegionSlice> slices,
                               Partition& partition, RegionTotals& totals, KernelSeconds& seconds);

}  // namespace geolloyd
