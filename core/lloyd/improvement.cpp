#include "core/lloyd/improvement.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/base/random.h"

namespace geolloyd {
namespace {

// Per region, those that share a border with it.
std::vector<std::vector<RegionId>> adjacent_regions(const Graph& graph,
                                                    const ScoredPartition& partition) {
  std::vector<std::vector<RegionId>> adjacent(partition.seeds.size());
  for (NodeId v = 0; v < graph.node_count(); ++v) {
    if (partition.key[v] == unreached) continue;
    std::vector<RegionId>& mine = adjacent[region_of(partition.key[v])];
    for (const NodeId u : graph.neighbours(v)) {
      if (same_region(partition.key, u, v)) continue;
      const RegionId other = region_of(partition.key[u]);
      if (std::find(mine.begin(), mine.end(), other) == mine.end()) mine.push_back(other);
    }
  }
  return adjacent;
}

// Per region, of equals the smallest.
std::vector<NodeId> farthest_nodes(const ScoredPartition& partition) {
  std::vector<NodeId> farthest = partition.seeds;
  for (NodeId v = 0; v < partition.key.size(); ++v) {
    if (partition.key[v] == unreached) continue;
    NodeId& most = farthest[region_of(partition.key[v])];
    if (distance_of(partition.key[v]) > distance_of(partition.key[most])) most = v;
  }
  return farthest;
}

class Perturbation {
 public:
  Perturbation(const Graph& graph, const ScoredPartition& base, std::uint64_t round)
      : base_(base),
        round_(round),
        adjacent_(adjacent_regions(graph, base)),
        farthest_(farthest_nodes(base)),
        seeds_(base.seeds),
        is_taken_(base.seeds.size(), 0) {}

  std::vector<NodeId> make() {
    transfer();
    shake();
    return std::move(seeds_);
  }

 private:
  // One seed more or less changes the energy by about the score of a region there. That of one
  // region alone says little: its neighbours may have what it lacks.
  [[nodiscard]] std::vector<Score> mean_scores() const {
    std::vector<Score> means(seeds_.size());
    for (RegionId r = 0; r < means.size(); ++r) {
      Score sum = base_.scores[r];
      for (const RegionId n : adjacent_[r]) sum += base_.scores[n];
      means[r] = sum / (adjacent_[r].size() + 1);
    }
    return means;
  }

  // Seeds of the cheapest regions go to the farthest nodes of the dearest.
  void transfer() {
    const std::vector<Score> cost = mean_scores();
    std::vector<RegionId> order(seeds_.size());
    std::iota(order.begin(), order.end(), RegionId{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](RegionId a, RegionId b) { return cost[a] < cost[b]; });
    auto dear = order.rbegin();
    for (const RegionId cheap : order) {
      if (is_taken_[cheap] != 0 || adjacent_[cheap].empty()) continue;
      while (dear != order.rend() && !can_have_another(*dear)) ++dear;
      if (dear == order.rend() || cost[*dear] < 2 * cost[cheap] || *dear == cheap) return;
      seeds_[cheap] = farthest_[*dear];
      take_around(cheap, 1);
      take_around(*dear, 1);
    }
  }

  [[nodiscard]] bool can_have_another(RegionId r) const {
    return is_taken_[r] == 0 && farthest_[r] != seeds_[r];
  }

  void shake() {
    for (const RegionId r : irregular_first()) {
      if (is_taken_[r] != 0) continue;
      take_around(r, 2);
      is_taken_[r] = shaken;
    }
    std::vector<std::uint64_t> least(seeds_.size(), std::numeric_limits<std::uint64_t>::max());
    for (NodeId v = 0; v < base_.key.size(); ++v) {
      if (base_.key[v] == unreached) continue;
      const RegionId r = region_of(base_.key[v]);
      if (is_taken_[r] != shaken || is_outermost(v)) continue;
      const std::uint64_t drawn = random_bits(round_, v);
      if (drawn >= least[r]) continue;
      least[r] = drawn;
      seeds_[r] = v;
    }
  }

  [[nodiscard]] std::vector<RegionId> irregular_first() const {
    std::vector<std::tuple<bool, std::uint64_t, RegionId>> drawn;
    drawn.reserve(seeds_.size());
    for (RegionId r = 0; r < seeds_.size(); ++r) {
      drawn.emplace_back(adjacent_[r].size() == 6, random_bits(round_, r), r);
    }
    std::sort(drawn.begin(), drawn.end());
    std::vector<RegionId> order;
    order.reserve(drawn.size());
    for (const auto& [is_regular, number, r] : drawn) order.push_back(r);
    return order;
  }

  // The last fifth of the way to the farthest node.
  [[nodiscard]] bool is_outermost(NodeId v) const {
    const std::uint64_t most = distance_of(base_.key[farthest_[region_of(base_.key[v])]]);
    return 5 * std::uint64_t{distance_of(base_.key[v])} > 4 * most;
  }

  void take_around(RegionId r, int rings) {
    is_taken_[r] = taken;
    if (rings == 0) return;
    for (const RegionId n : adjacent_[r]) take_around(n, rings - 1);
  }

  static constexpr std::uint8_t taken = 1;
  static constexpr std::uint8_t shaken = 2;

  const ScoredPartition& base_;
  std::uint64_t round_;
  std::vector<std::vector<RegionId>> adjacent_;
  std::vector<NodeId> farthest_;
  std::vector<NodeId> seeds_;
  std::vector<std::uint8_t> is_taken_;  // per region: part of a perturbation
};

}  // namespace

std::vector<NodeId> perturb(const Graph& graph, const ScoredPartition& base, std::uint64_t round) {
  return Perturbation(graph, base, round).make();
}

std::vector<std::uint8_t> lower_clusters(const ScoredPartition& base,
                                         const ScoredPartition& other) {
  const std::size_t regions = base.seeds.size();
  DisjointSets clusters(regions);
  for (NodeId v = 0; v < base.key.size(); ++v) {
    if (base.key[v] == other.key[v]) continue;
    clusters.unite(region_of(base.key[v]), region_of(other.key[v]));
  }
  std::vector<Score> before(regions, 0);
  std::vector<Score> after(regions, 0);
  for (RegionId r = 0; r < regions; ++r) {
    before[clusters.find(r)] += base.scores[r];
    after[clusters.find(r)] += other.scores[r];
  }
  std::vector<std::uint8_t> is_lower(regions, 0);
  for (RegionId r = 0; r < regions; ++r) {
    const RegionId cluster = clusters.find(r);
    is_lower[r] = after[cluster] < before[cluster] ? 1 : 0;
  }
  return is_lower;
}

}  // namespace geolloyd
