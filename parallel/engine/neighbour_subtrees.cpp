#include "parallel/engine/neighbour_subtrees.h"

#include <algorithm>
#include <atomic>

#include "core/base/loops.h"

namespace geolloyd {
namespace {

constexpr std::uint32_t unknown = no_branch - 1;

// Two threads may tell a node its branch at once. Both tell it the same.
std::uint32_t load(const std::uint32_t& branch) {
  return std::atomic_ref(const_cast<std::uint32_t&>(branch)).load(std::memory_order_relaxed);
}
void store(std::uint32_t& branch, std::uint32_t value) {
  std::atomic_ref(branch).store(value, std::memory_order_relaxed);
}

std::uint32_t find_branch(const Partition& partition, NodeId v, BranchOf& branch_of) {
  NodeId known = v;
  while (load(branch_of[known]) == unknown) known = partition.parent[known];
  const std::uint32_t branch = load(branch_of[known]);
  for (NodeId u = v; u != known; u = partition.parent[u]) store(branch_of[u], branch);
  return branch;
}

// Where the branch of the seed's neighbour `w` hangs: the number of the arc to a neighbour above
// it, or no_branch where it hangs from the seed.
std::uint32_t branch_above(const Partition& partition, NodeId seed, NodeId w,
                           const BranchOf& branch_of) {
  return partition.parent[w] == seed ? no_branch : branch_of[partition.parent[w]];
}

}  // namespace

void forget_branches(std::span<const NodeId> nodes, BranchOf& branch_of) {
  for (const NodeId v : nodes) branch_of[v] = unknown;
}

void mark_branches(const Graph& graph, const std::vector<Key>& keys, NodeId seed,
                   BranchOf& branch_of) {
  const std::span<const NodeId> neighbours = graph.neighbours(seed);
  for (std::uint32_t i = 0; i < neighbours.size(); ++i) {
    if (same_region(keys, seed, neighbours[i])) branch_of[neighbours[i]] = i;
  }
  branch_of[seed] = no_branch;
}

void add_to_branches(const Graph& graph, const Partition& partition, std::span<const NodeId> nodes,
                     BranchOf& branch_of, std::span<BranchSum> sums) {
  for (const NodeId v : nodes) {
    const std::uint32_t branch = find_branch(partition, v, branch_of);
    if (branch == no_branch) continue;
    sums[branch].cost += distance_of(partition.key[v]);
    sums[branch].mass += graph.mass[v];
  }
}

void add_up_branches(const Graph& graph, const Partition& partition, NodeId seed,
                     const BranchOf& branch_of, std::span<BranchSum> sums, SubtreeSums& sums_at) {
  const std::span<const NodeId> neighbours = graph.neighbours(seed);
  std::vector<std::uint32_t> hanging;
  for (std::uint32_t i = 0; i < neighbours.size(); ++i) {
    const NodeId w = neighbours[i];
    if (same_region(partition.key, seed, w) && partition.parent[w] != seed) hanging.push_back(i);
  }
  // Farthest first: what hangs from a branch is farther than the branch.
  std::sort(hanging.begin(), hanging.end(), [&](std::uint32_t a, std::uint32_t b) {
    return partition.key[neighbours[a]] > partition.key[neighbours[b]];
  });
  for (const std::uint32_t i : hanging) {
    const std::uint32_t above = branch_above(partition, seed, neighbours[i], branch_of);
    sums[above] += sums[i];
  }
  for (std::uint32_t i = 0; i < neighbours.size(); ++i) {
    if (!same_region(partition.key, seed, neighbours[i])) continue;
    sums_at.cost[neighbours[i]] = sums[i].cost;
    sums_at.mass[neighbours[i]] = sums[i].mass;
  }
}

void find_branches(const Graph& graph, const Partition& partition, NodeId seed,
                   std::span<const NodeId> nodes, BranchOf& branch_of, std::vector<BranchSum>& sums,
                   SubtreeSums& sums_at) {
  sums.assign(graph.neighbours(seed).size(), {});
  forget_branches(nodes, branch_of);
  mark_branches(graph, partition.key, seed, branch_of);
  add_to_branches(graph, partition, nodes, branch_of, sums);
  add_up_branches(graph, partition, seed, branch_of, sums, sums_at);
}

namespace {

// Consecutive parts of a region in one, until it has as many nodes as the seed has arcs: so sums
// never take more memory than nodes, even around a seed with millions of neighbours.
std::vector<RegionSlice> join_parts(const Graph& graph, std::span<const NodeId> seeds,
                                    std::span<const RegionSlice> parts) {
  std::vector<RegionSlice> joined;
  for (const RegionSlice& p : parts) {
    const bool extends =
        !joined.empty() && joined.back().region == p.region &&
        joined.back().end - joined.back().begin < graph.neighbours(seeds[p.region]).size();
    if (extends) {
      joined.back().end = p.end;
    } else {
      joined.push_back(p);
    }
  }
  return joined;
}

// Several threads to a region: each step is done for all before the next begins.
void find_branches_of_parts(Scheduler& scheduler, const Graph& graph, std::span<const NodeId> seeds,
                            const Partition& partition, const RegionNodes& region_nodes,
                            std::span<const RegionSlice> slices, BranchOf& branch_of,
                            SubtreeSums& sums_at) {
  const std::vector<RegionSlice> parts = join_parts(graph, seeds, slices);
  const auto is_first = [&](std::size_t i) {
    return i == 0 || parts[i].region != parts[i - 1].region;
  };
  parallel_for(scheduler, parts.size(), 1, [&](std::size_t i) {
    forget_branches(nodes_of(region_nodes, parts[i]), branch_of);
  });
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (is_first(i)) mark_branches(graph, partition.key, seeds[parts[i].region], branch_of);
  }
  std::vector<std::vector<BranchSum>> sums(parts.size());
  parallel_for(scheduler, parts.size(), 1, [&](std::size_t i) {
    sums[i].resize(graph.neighbours(seeds[parts[i].region]).size());
    add_to_branches(graph, partition, nodes_of(region_nodes, parts[i]), branch_of, sums[i]);
  });
  for (std::size_t first = 0; first < parts.size();) {
    const RegionId region = parts[first].region;
    std::size_t next = first + 1;
    for (; next < parts.size() && !is_first(next); ++next) {
      for (std::size_t b = 0; b < sums[first].size(); ++b) sums[first][b] += sums[next][b];
    }
    add_up_branches(graph, partition, seeds[region], branch_of, sums[first], sums_at);
    first = next;
  }
}

}  // namespace

void find_branches(Scheduler& scheduler, const Graph& graph, std::span<const NodeId> seeds,
                   const Partition& partition, const RegionNodes& region_nodes,
                   std::span<const RegionSlice> slices, BranchOf& branch_of, SubtreeSums& sums_at) {
  std::vector<std::vector<BranchSum>> of_worker(scheduler.threads());
  std::vector<RegionSlice> parts;  // of regions of several slices
  for (const RegionSlice& p : slices) {
    if (!is_whole(region_nodes, p)) parts.push_back(p);
  }
  parallel_for_ranges(scheduler, slices.size(), grain_of(slices),
                      [&](std::size_t begin, std::size_t end, std::size_t worker) {
                        for (std::size_t i = begin; i < end; ++i) {
                          if (!is_whole(region_nodes, slices[i])) continue;
                          find_branches(graph, partition, seeds[slices[i].region],
                                        nodes_of(region_nodes, slices[i]), branch_of,
                                        of_worker[worker], sums_at);
                        }
                      });
  find_branches_of_parts(scheduler, graph, seeds, partition, region_nodes, parts, branch_of,
                         sums_at);
}

// Answers are kept on the way up: of many branches one above the other each is climbed once.
void find_branches_below(const Graph& graph, const Partition& partition, NodeId seed,
                         const BranchOf& branch_of, NodeId top, std::vector<std::uint8_t>& below) {
  constexpr std::uint8_t open = 2;
  const std::span<const NodeId> neighbours = graph.neighbours(seed);
  const auto above = [&](std::uint32_t b) {
    return branch_above(partition, seed, neighbours[b], branch_of);
  };
  below.assign(neighbours.size(), open);
  for (std::uint32_t i = 0; i < neighbours.size(); ++i) {
    if (!same_region(partition.key, seed, neighbours[i])) below[i] = 0;
    if (neighbours[i] == top) below[i] = 1;
  }
  for (std::uint32_t i = 0; i < neighbours.size(); ++i) {
    std::uint32_t known = i;
    while (known != no_branch && below[known] == open) known = above(known);
    const std::uint8_t answer = known != no_branch ? below[known] : 0;
    for (std::uint32_t b = i; b != known; b = above(b)) below[b] = answer;
  }
}

}  // namespace geolloyd
