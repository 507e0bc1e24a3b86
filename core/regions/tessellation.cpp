#include "core/regions/tessellation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace geolloyd {

std::vector<RegionSummary> summarise_regions(const Graph& graph, const Partition& partition,
                                             std::span<const NodeId> seeds,
                                             std::span<const Score> region_score) {
  std::vector<std::uint64_t> mass(seeds.size(), 0);
  std::vector<RegionSummary> regions(seeds.size());
  for (NodeId v = 0; v < graph.node_count(); ++v) {
    const RegionId r = region_of(partition.key[v]);
    if (r == no_id) continue;
    ++regions[r].node_count;
    mass[r] += graph.mass[v];
  }
  for (std::size_t r = 0; r < seeds.size(); ++r) {
    regions[r].seed = seeds[r];
    regions[r].area = static_cast<double>(mass[r]) * graph.tick_mass;
    regions[r].energy = to_energy(graph, region_score[r]);
  }
  return regions;
}

RegionSpread region_spread(std::span<const RegionSummary> regions) {
  const auto count = static_cast<double>(regions.size());
  double mean = 0;
  for (const RegionSummary& region : regions) mean += region.area / count;
  double variance = 0;
  double smallest = regions.front().area;
  double largest = smallest;
  for (const RegionSummary& region : regions) {
    variance += (region.area - mean) * (region.area - mean) / count;
    smallest = std::min(smallest, region.area);
    largest = std::max(largest, region.area);
  }
  return {std::sqrt(variance) / mean, smallest / mean, largest / mean};
}

std::vector<std::pair<RegionId, RegionId>> adjacent_regions(const Graph& graph,
                                                            const Partition& partition) {
  std::vector<std::pair<RegionId, RegionId>> pairs;
  for (NodeId v = 0; v < graph.node_count(); ++v) {
    const RegionId a = region_of(partition.key[v]);
    for (const NodeId u : graph.neighbours(v)) {
      const RegionId b = region_of(partition.key[u]);
      if (a < b && b != no_id) pairs.emplace_back(a, b);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::vector<std::uint32_t> colour_regions(std::size_t region_count,
                                          std::span<const std::pair<RegionId, RegionId>> adjacent,
                                          std::uint32_t preferred_colours) {
  std::vector<std::vector<RegionId>> neighbours(region_count);
  for (const auto& [a, b] : adjacent) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  std::vector<RegionId> order(region_count);
  std::iota(order.begin(), order.end(), RegionId{0});
  std::stable_sort(order.begin(), order.end(), [&](RegionId a, RegionId b) {
    return neighbours[a].size() > neighbours[b].size();
  });

  constexpr std::uint32_t uncoloured = no_id;
  std::vector<std::uint32_t> colour(region_count, uncoloured);
  std::vector<std::size_t> uses(preferred_colours, 0);
  std::vector<bool> taken;
  for (const RegionId r : order) {
    taken.assign(uses.size(), false);
    for (const RegionId n : neighbours[r]) {
      if (colour[n] != uncoloured) taken[colour[n]] = true;
    }
    std::uint32_t best = uncoloured;
    for (std::uint32_t c = 0; c < uses.size(); ++c) {
      if (taken[c]) continue;
      const bool first_choice = c < preferred_colours;
      if (best == uncoloured || (first_choice && uses[c] < uses[best])) best = c;
    }
    if (best == uncoloured) {
      best = static_cast<std::uint32_t>(uses.size());
      uses.push_back(0);
    }
    colour[r] = best;
    ++uses[best];
  }
  return colour;
}

}  // namespace geolloyd
