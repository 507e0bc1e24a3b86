#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/graph/graph.h"
#include "core/voronoi/energy.h"
#include "core/voronoi/partition.h"

namespace geolloyd {

/// One region of a finished relaxation, in mesh units.
struct RegionSummary {
  NodeId seed = no_id;
  std::uint32_t node_count = 0;
  double area = 0;    ///< sum of its nodes' masses
  double energy = 0;  ///< sum of mass * distance^2
};

std::vector<RegionSummary> summarise_regions(const Graph& graph, const Partition& partition,
                                             std::span<const NodeId> seeds,
                                             std::span<const Score> region_score);

/// How even the areas of regions are, as ratios to their mean. Not numbers without area.
struct RegionSpread {
  double deviation = 0;  ///< standard deviation
  double smallest = 0;
  double largest = 0;
};

/// `regions`: at least one.
RegionSpread region_spread(std::span<const RegionSummary> regions);

/// Pairs of regions that an arc joins, the smaller first, ascending.
std::vector<std::pair<RegionId, RegionId>> adjacent_regions(const Graph& graph,
                                                            const Partition& partition);

/// A small colour number per region, different for adjacent regions. Greedy, most neighbours first
/// (Welsh and Powell 1967); of the colours free among the first `preferred_colours` the one used
/// least so far, so that all of them show; further ones only where these do not suffice.
std::vector<std::uint32_t> colour_regions(std::size_t region_count,
                                          std::span<const std::pair<RegionId, RegionId>> adjacent,
                                          std::uint32_t preferred_colours);

}  // namespace geolloyd
