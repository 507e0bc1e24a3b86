#include "parallel/engine/region_nodes.h"

#include <algorithm>

#include "core/base/loops.h"

namespace geolloyd {
namespace {

// Each thread counts and places the nodes of one block. A block needs a counter per region, which
// does not pay where regions are few nodes each.
std::size_t choose_block_size(Scheduler& scheduler, std::size_t nodes, std::size_t regions) {
  constexpr std::size_t nodes_per_counter = 4;
  const std::size_t blocks =
      std::clamp<std::size_t>(nodes / (nodes_per_counter * regions + 1), 1, scheduler.threads());
  return (nodes + blocks) / blocks;
}

}  // namespace

void find_region_nodes(Scheduler& scheduler, std::span<const Key> keys, std::size_t regions,
                       RegionNodes& region_nodes) {
  const std::size_t size = choose_block_size(scheduler, keys.size(), regions);
  const std::size_t blocks = (keys.size() + size - 1) / size;
  // By block and region: first the number of nodes there, then where the next of them goes.
  std::vector<NodeId> slot(blocks * regions, 0);
  parallel_for_ranges(scheduler, keys.size(), size,
                      [&](std::size_t begin, std::size_t end, std::size_t) {
                        NodeId* const count = slot.data() + begin / size * regions;
                        for (std::size_t v = begin; v < end; ++v) {
                          if (keys[v] != unreached) ++count[region_of(keys[v])];
                        }
                      });

  region_nodes.first.resize(regions + 1);
  NodeId total = 0;
  for (std::size_t r = 0; r < regions; ++r) {
    region_nodes.first[r] = total;
    for (std::size_t b = 0; b < blocks; ++b) {
      const NodeId count = slot[b * regions + r];
      slot[b * regions + r] = total;
      total += count;
    }
  }
  region_nodes.first[regions] = total;

  region_nodes.node.resize(total);
  parallel_for_ranges(scheduler, keys.size(), size,
                      [&](std::size_t begin, std::size_t end, std::size_t) {
                        NodeId* const next = slot.data() + begin / size * regions;
                        for (std::size_t v = begin; v < end; ++v) {
                          if (keys[v] != unreached)
                            region_nodes.node[next[region_of(keys[v])]++] = static_cast<NodeId>(v);
                        }
                      });
}

std::span<const NodeId> nodes_of(const RegionNodes& region_nodes, const RegionSlice& slice) {
  return {region_nodes.node.data() + slice.begin, region_nodes.node.data() + slice.end};
}

bool is_whole(const RegionNodes& region_nodes, const RegionSlice& slice) {
  return slice.end - slice.begin == region_nodes.of(slice.region).size();
}

std::size_t grain_of(std::span<const RegionSlice> slices) {
  constexpr std::size_t nodes_a_task = 2048;
  std::size_t nodes = 1;
  for (const RegionSlice& p : slices) nodes += p.end - p.begin;
  return std::max<std::size_t>(nodes_a_task * slices.size() / nodes, 1);
}

std::vector<RegionSlice> cut_into_slices(const RegionNodes& region_nodes,
                                         std::span<const RegionId> regions) {
  constexpr NodeId most_nodes_a_piece = 4096;
  std::vector<RegionSlice> slices;
  slices.reserve(regions.size());
  for (const RegionId r : regions) {
    for (NodeId begin = region_nodes.first[r]; begin < region_nodes.first[r + 1];) {
      const NodeId end = std::min(begin + most_nodes_a_piece, region_nodes.first[r + 1]);
      slices.push_back({r, begin, end});
      begin = end;
    }
  }
  return slices;
}

}  // namespace geolloyd
