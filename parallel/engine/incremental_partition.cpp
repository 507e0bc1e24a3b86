#include "parallel/engine/incremental_partition.h"

#include <algorithm>

#include "core/base/loops.h"
#include "core/base/stopwatch.h"
#include "core/voronoi/dijkstra.h"
#include "core/voronoi/fingerprint.h"

namespace geolloyd {
namespace {

std::vector<RegionId> regions_where(const std::vector<std::uint8_t>& flags, bool set) {
  std::vector<RegionId> regions;
  for (RegionId r = 0; r < flags.size(); ++r) {
    if ((flags[r] != 0) == set) regions.push_back(r);
  }
  return regions;
}

}  // namespace

IncrementalPartition::IncrementalPartition(Scheduler& scheduler, const Graph& graph,
                                           Frontier frontier, KernelSeconds& seconds)
    : scheduler_(scheduler),
      graph_(graph),
      frontier_(frontier),
      delta_stepping_(scheduler, graph),
      seconds_(seconds),
      branch_of_(graph.node_count()) {
  partition_.parent.resize(graph.node_count());
}

void IncrementalPartition::update(std::span<const NodeId> seeds) {
  {
    const Timed timed(seconds_.free_search);
    const bool repairable = can_repair(seeds);
    has_partition_ = false;  // until it has, whatever is thrown
    if (!repairable || !search_from_last(seeds)) search_from_scratch(seeds);
    seeds_.assign(seeds.begin(), seeds.end());
  }
  {
    const Timed timed(seconds_.gathering);
    find_region_nodes(scheduler_, partition_.key, seeds.size(), region_nodes_);
  }
  derive_changed();
  has_partition_ = true;
}

std::vector<RegionId> IncrementalPartition::update_sums() {
  const Timed timed(seconds_.subtree_sums);
  sums_.cost.resize(graph_.node_count());  // only the greedy phase asks for them
  sums_.mass.resize(graph_.node_count());
  std::vector<RegionId> regions = regions_where(has_sums_, false);
  find_branches(scheduler_, graph_, seeds_, partition_, region_nodes_,
                cut_into_slices(region_nodes_, regions), branch_of_, sums_);
  has_sums_.assign(seeds_.size(), 1);
  return regions;
}

std::uint64_t IncrementalPartition::digest_of_nodes() const {
  std::uint64_t sum = digest_of_unreached_;
  for (const std::uint64_t d : totals_.digest) sum += d;
  return sum;
}

void IncrementalPartition::moved_to(std::span<const NodeId> seeds) {
  for (RegionId r = 0; r < seeds.size(); ++r) {
    if (seeds[r] == seeds_[r]) continue;
    seeds_[r] = seeds[r];
    is_changed_[r] = 1;
    has_sums_[r] = 0;
  }
  has_partition_ = true;
}

// Seeds that moved within their regions, and further seeds, leave upper bounds to start from. So do
// seeds that left their regions, if most of the others stayed.
bool IncrementalPartition::can_repair(std::span<const NodeId> seeds) const {
  if (!has_partition_ || seeds.size() < seeds_.size()) return false;
  if (frontier_ == Frontier::heap || frontier_ == Frontier::delta) return false;
  std::size_t left = 0;
  for (RegionId r = 0; r < seeds_.size(); ++r) {
    if (region_of(partition_.key[seeds[r]]) != r) ++left;
  }
  for (const NodeId s : seeds) {
    if (partition_.key[s] == unreached) return false;
  }
  return 4 * left <= seeds_.size();
}

void IncrementalPartition::search_from_scratch(std::span<const NodeId> seeds) {
  if (frontier_ == Frontier::heap) {
    IndexedHeap heap(graph_.node_count());
    std::vector<NodeId> settled;
    search_free(graph_, seeds, heap, partition_.key, settled);
  } else {
    delta_stepping_.search(seeds, partition_.key);
  }
  sum_unreached();
  is_changed_.assign(seeds.size(), 1);
  has_sums_.assign(seeds.size(), 0);
  totals_.score.assign(seeds.size(), 0);
  totals_.digest.assign(seeds.size(), 0);
}

void IncrementalPartition::sum_unreached() {
  digest_of_unreached_ = parallel_reduce<std::uint64_t>(
      scheduler_, graph_.node_count(), 1 << 15, [&](std::size_t begin, std::size_t end) {
        std::uint64_t sum = 0;
        for (std::size_t v = begin; v < end; ++v) {
          if (partition_.key[v] != unreached) continue;
          partition_.parent[v] = no_id;
          sum += digest(static_cast<NodeId>(v), unreached, no_id);
        }
        return sum;
      });
}

// Returns false where that leaves nodes unreached that were not.
bool IncrementalPartition::search_from_last(std::span<const NodeId> seeds) {
  std::vector<RegionId> moved;
  std::vector<RegionId> left;
  for (RegionId r = 0; r < seeds_.size(); ++r) {
    if (seeds[r] == seeds_[r]) continue;
    (region_of(partition_.key[seeds[r]]) == r ? moved : left).push_back(r);
    is_changed_[r] = 1;
  }
  shift_keys(moved, seeds);
  vacate(left);
  for (const RegionId r : left) plant(r, seeds[r]);
  for (std::size_t r = seeds_.size(); r < seeds.size(); ++r) {
    plant(static_cast<RegionId>(r), seeds[r]);
  }
  const std::vector<RegionId> suspects = regions_where(is_changed_, true);
  add_regions(seeds.size());
  delta_stepping_.repair(region_nodes_, cut_into_slices(region_nodes_, suspects), partition_.key,
                         is_changed_);
  return !is_vacant(left);
}

// Where a seed moved within its region, no node is farther than it was plus the way back to the old
// seed, and those in the subtree of the new one are nearer by as much.
void IncrementalPartition::shift_keys(std::span<const RegionId> moved,
                                      std::span<const NodeId> seeds) {
  struct Shift {
    std::uint32_t way = 0;
    std::vector<std::uint8_t> below;  // per branch, where known
  };
  std::vector<Shift> shift_of(moved.size());
  std::vector<std::uint32_t> place(seeds.size());
  parallel_for(scheduler_, moved.size(), 64, [&](std::size_t i) {
    const RegionId r = moved[i];
    place[r] = static_cast<std::uint32_t>(i);
    shift_of[i].way = distance_of(partition_.key[seeds[r]]);
    if (has_sums_[r] != 0) {
      find_branches_below(graph_, partition_, seeds_[r], branch_of_, seeds[r], shift_of[i].below);
    }
  });
  const std::vector<RegionSlice> slices = cut_into_slices(region_nodes_, moved);
  parallel_for(scheduler_, slices.size(), grain_of(slices), [&](std::size_t i) {
    const Shift& shift = shift_of[place[slices[i].region]];
    for (const NodeId v : nodes_of(region_nodes_, slices[i])) {
      Key& key = partition_.key[v];
      key = bound_after_move(key, branch_of_[v], shift.below, shift.way);
    }
  });
  for (const RegionId r : moved) partition_.key[seeds[r]] = make_key(0, r);
}

// Nodes of regions whose seeds have left them go to their neighbours.
void IncrementalPartition::vacate(std::span<const RegionId> regions) {
  parallel_for(scheduler_, regions.size(), 1, [&](std::size_t i) {
    for (const NodeId v : region_nodes_.of(regions[i])) partition_.key[v] = unreached;
  });
}

// Whether no region has come to have a node of theirs.
bool IncrementalPartition::is_vacant(std::span<const RegionId> regions) const {
  return std::ranges::any_of(regions, [&](RegionId r) {
    return std::ranges::any_of(region_nodes_.of(r),
                               [&](NodeId v) { return partition_.key[v] == unreached; });
  });
}

// The seed takes its nodes from other regions.
void IncrementalPartition::plant(RegionId region, NodeId seed) {
  Key& key = partition_.key[seed];
  if (region_of(key) < seeds_.size()) is_changed_[region_of(key)] = 1;
  key = make_key(0, region);
}

void IncrementalPartition::add_regions(std::size_t count) {
  is_changed_.resize(count, 1);
  has_sums_.resize(count, 0);
  totals_.score.resize(count, 0);
  totals_.digest.resize(count, 0);
}

void IncrementalPartition::derive_changed() {
  const std::vector<RegionId> changed = regions_where(is_changed_, true);
  derive_parents_and_totals(scheduler_, graph_, region_nodes_,
                            cut_into_slices(region_nodes_, changed), partition_, totals_, seconds_);
  for (const RegionId r : changed) has_sums_[r] = 0;
  is_changed_.assign(seeds_.size(), 0);
}

}  // namespace geolloyd
