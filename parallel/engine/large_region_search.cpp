#include "parallel/engine/large_region_search.h"

#include <numeric>

#include "core/base/loops.h"
#include "core/voronoi/forest.h"

namespace geolloyd {
namespace {

constexpr std::size_t grain = 4096;

}  // namespace

LargeRegionSearch::LargeRegionSearch(Scheduler& scheduler, const Graph& graph)
    : scheduler_(scheduler),
      graph_(graph),
      delta_stepping_(scheduler, graph),
      keys_(graph.node_count()) {
  region_nodes_.first = {0, static_cast<NodeId>(graph.node_count())};
  region_nodes_.node.resize(graph.node_count());
  std::iota(region_nodes_.node.begin(), region_nodes_.node.end(), NodeId{0});
  constexpr RegionId only = 0;
  slices_ = cut_into_slices(region_nodes_, {&only, 1});
}

void LargeRegionSearch::run(const Partition& partition, NodeId current, const BranchOf& branch_of,
                            NodeId source) {
  source_ = source;
  const std::uint32_t distance = distance_of(partition.key[source]);
  std::vector<std::uint8_t> below;
  find_branches_below(graph_, partition, current, branch_of, source, below);
  const auto is_nearer = [&](std::size_t v) {
    return branch_of[v] < below.size() && below[branch_of[v]] != 0;
  };
  nearer_of_worker_.resize(scheduler_.threads());
  for (std::vector<NodeId>& nearer : nearer_of_worker_) nearer.clear();
  parallel_for_ranges(
      scheduler_, keys_.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t worker) {
        for (auto v = static_cast<NodeId>(begin); v < end; ++v) {
          keys_[v] = bound_after_move(partition.key[v], branch_of[v], below, distance);
          if (is_nearer(v)) nearer_of_worker_[worker].push_back(v);
        }
      });
  keys_[source] = make_key(0, 0);
  nearer_.assign(1, source);
  for (const std::vector<NodeId>& nearer : nearer_of_worker_) {
    nearer_.insert(nearer_.end(), nearer.begin(), nearer.end());
  }
  // What is nearer knows its distance, and no other bounds contradict each other.
  delta_stepping_.lower_from(nearer_, keys_);
}

void LargeRegionSearch::derive_parents(Partition& partition) {
  parallel_for(scheduler_, slices_.size(), 1, [&](std::size_t i) {
    geolloyd::derive_parents(graph_, partition.key, nodes_of(region_nodes_, slices_[i]),
                             partition.parent);
  });
}

void LargeRegionSearch::find_sums(NodeId current, const Partition& partition, BranchOf& branch_of,
                                  SubtreeSums& sums) {
  find_branches(scheduler_, graph_, {&current, 1}, partition, region_nodes_, slices_, branch_of,
                sums);
}

Score LargeRegionSearch::score() const {
  return parallel_reduce<Score>(scheduler_, keys_.size(), grain,
                                [&](std::size_t begin, std::size_t end) {
                                  Score sum = 0;
                                  for (std::size_t v = begin; v < end; ++v) {
                                    sum += node_score(distance_of(keys_[v]), graph_.mass[v]);
                                  }
                                  return sum;
                                });
}

}  // namespace geolloyd
