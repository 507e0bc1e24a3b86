#include "parallel/engine/region_relaxation.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "core/voronoi/forest.h"
#include "parallel/threads/atomic_key.h"

namespace geolloyd {

void RegionRelaxation::gather(const Graph& graph, const std::vector<Key>& keys,
                              std::span<const NodeId> nodes, std::vector<NodeId>& local_of,
                              Scheduler* shared) {
  laps_.begin(weight_of_time(nodes.size(), shared));
  copy_region(graph, keys, nodes, local_of, local_);
  constexpr std::size_t large_size = 1 << 13;  // nodes: lanes of so many leave the cache
  Scheduler& workers = shared != nullptr ? *shared : alone_;
  large_ = shared != nullptr || nodes.size() >= large_size
               ? std::make_unique<LargeRegionSearch>(workers, local_.graph)
               : nullptr;
  laps_.end(seconds_.gathering);
}

// Counts the time of all threads. Small regions are settled in little more time than it takes to
// measure that, so every eighth of them stands for all.
double RegionRelaxation::weight_of_time(std::size_t nodes, const Scheduler* shared) {
  constexpr std::size_t small = 512;
  constexpr std::size_t every = 8;
  if (shared != nullptr) return static_cast<double>(shared->threads());
  if (nodes >= small) return 1;
  return small_regions_++ % every == 0 ? every : 0;
}

void RegionRelaxation::scatter_keys(RegionId region, std::vector<Key>& keys) {
  for (NodeId v = 0; v < local_.size(); ++v) {
    store_key(keys[local_.node[v]], make_key(distance_of(local_.partition.key[v]), region));
  }
  laps_.end(seconds_.gathering);
}

RegionRelaxation::Outcome RegionRelaxation::relax(NodeId seed, Score score, bool extended,
                                                  std::vector<NodeId>* trail) {
  extended_ = extended;
  const auto place = std::lower_bound(local_.node.begin(), local_.node.end(), seed);
  auto at = static_cast<NodeId>(place - local_.node.begin());
  begin(at, score);
  std::uint32_t moves = 0;
  NodeId unbeaten = no_id;  // where no neighbour scored so far is lower
  while (goes_on_()) {
    NodeId next =
        at == unbeaten ? no_id : lower_neighbour(local_.graph, local_.partition.key, score_, at);
    if (next == no_id) {
      unbeaten = at;
      settle_at(at);
      next = best_candidate();
    }
    if (next == no_id) break;
    if (score_[next] == never_scored) {
      score_[next] = score_of(next);
      if (score_[next] < score_[unbeaten]) unbeaten = no_id;
    }
    at = next;
    ++moves;
    if (trail != nullptr) trail->push_back(local_.node[at]);
  }
  laps_.end(seconds_.movement);
  return {local_.node[at], moves};
}

void RegionRelaxation::begin(NodeId seed, Score score) {
  const std::size_t nodes = local_.size();
  score_.assign(nodes, never_scored);
  ahead_.assign(nodes, never_scored);
  score_[seed] = score;
  mass_ = std::accumulate(local_.graph.mass.begin(), local_.graph.mass.end(), std::uint64_t{0});
  if (order_.size() < nodes) {  // the last to grow
    all_.resize(nodes);
    std::iota(all_.begin(), all_.end(), NodeId{0});
    branch_of_.resize(nodes);
    sums_.cost.resize(nodes);
    sums_.mass.resize(nodes);
    order_.resize(nodes);
  }
  current_ = no_id;
  sources_.clear();
  laps_.end(seconds_.gathering);
}

void RegionRelaxation::settle_at(NodeId node) {
  if (current_ == node) return;
  if (current_ != no_id) move_keys_to(node);  // else they are there already
  current_ = node;
  sources_.clear();
  weigh_neighbours();
}

void RegionRelaxation::move_keys_to(NodeId node) {
  if (large_) {
    if (large_->source() != node) search_large(node);
    large_->swap_keys(local_.partition.key);
    return;
  }
  auto source = std::find(sources_.begin(), sources_.end(), node);
  if (source == sources_.end()) {
    sources_.assign(1, node);
    search_from_sources();
    source = sources_.begin();
  }
  const auto lane = static_cast<std::size_t>(source - sources_.begin());
  for (NodeId v = 0; v < local_.size(); ++v) {
    local_.partition.key[v] = make_key(lanes_.distance(v, lane), 0);
  }
  laps_.end(seconds_.locked_search);
}

void RegionRelaxation::find_sums() {
  const std::span<const NodeId> nodes = std::span<const NodeId>(all_).first(local_.size());
  if (large_) {
    large_->derive_parents(local_.partition);
  } else {
    derive_parents(local_.graph, local_.partition.key, nodes, local_.partition.parent);
  }
  laps_.end(seconds_.locked_search);
  if (large_) {
    large_->find_sums(current_, local_.partition, branch_of_, sums_);
  } else {
    find_branches(local_.graph, local_.partition, current_, nodes, branch_of_, branch_sums_, sums_);
  }
  laps_.end(seconds_.subtree_sums);
}

void RegionRelaxation::weigh_neighbours() {
  find_sums();
  const SeedMoveView view{local_.graph, local_.partition, sums_, extended_};
  candidates_.clear();
  for (const NodeId v : local_.graph.neighbours(current_)) {
    if (score_[v] == never_scored) candidates_.push_back({heuristic(view, current_, v), v});
  }
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
    return a.heuristic != b.heuristic ? a.heuristic > b.heuristic : a.node < b.node;
  });
  first_candidate_ = 0;
  laps_.end(seconds_.movement);
}

NodeId RegionRelaxation::best_candidate() {
  for (; first_candidate_ < candidates_.size(); ++first_candidate_) {
    const NodeId node = candidates_[first_candidate_].node;
    if (score_[node] == never_scored) return node;
  }
  return no_id;
}

Score RegionRelaxation::score_of(NodeId node) {
  if (ahead_[node] != never_scored) return ahead_[node];
  if (!large_) {
    look_ahead(node);
    return ahead_[node];
  }
  search_large(node);
  const Score score = large_->score();
  rule_out(score, [&](NodeId v) { return large_->distance(v); });
  laps_.end(seconds_.scoring);
  return score;
}

// Where the current seed has very many neighbours, most need no search. No node's distance from a
// neighbour v differs from that from another, u, by more than these are apart. So by Minkowski's
// inequality the roots of their scores differ by that times the root of the mass at most. If u
// cannot come down to the score of the current seed, it counts as infinitely high: the seed goes
// there and comes back as it would from any higher score. All doubles are off by less than the
// margin.
template <class DistanceFrom>
void RegionRelaxation::rule_out(Score score, const DistanceFrom& distance) {
  constexpr std::size_t many = 64;
  constexpr double margin = 1e-12;
  if (candidates_.size() < many) return;
  const double surplus = std::sqrt(static_cast<double>(score)) * (1 - margin) -
                         std::sqrt(static_cast<double>(score_[current_])) * (1 + margin);
  const double reach = surplus / std::sqrt(static_cast<double>(mass_)) * (1 - margin);
  for (std::size_t i = first_candidate_; i < candidates_.size(); ++i) {
    const NodeId u = candidates_[i].node;
    if (score_[u] != never_scored || ahead_[u] != never_scored) continue;
    if (static_cast<double>(distance(u)) < reach) ahead_[u] = never_scored - 1;
  }
}

void RegionRelaxation::search_large(NodeId source) {
  large_->run(local_.partition, current_, branch_of_, source);
  laps_.end(seconds_.locked_search);
}

// Fills the lanes with `node` and what may follow it.
void RegionRelaxation::look_ahead(NodeId node) {
  sources_.assign(1, node);
  for (std::size_t i = first_candidate_; i < candidates_.size(); ++i) {
    const Candidate& p = candidates_[i];
    if (sources_.size() == SimdSearch::lanes) break;
    const bool wanted = score_[p.node] == never_scored && ahead_[p.node] == never_scored;
    if (wanted && p.node != node) sources_.push_back(p.node);
  }
  search_from_sources();
  const auto scores = lanes_.scores(local_.graph);
  for (std::size_t j = 0; j < sources_.size(); ++j) ahead_[sources_[j]] = scores[j];
  for (std::size_t j = 0; j < sources_.size(); ++j) {
    rule_out(scores[j], [&](NodeId v) { return lanes_.distance(v, j); });
  }
  laps_.end(seconds_.scoring);
}

void RegionRelaxation::search_from_sources() {
  find_order();
  offset_.resize(local_.graph.neighbours(current_).size() + 1);
  for (std::size_t j = 0; j < SimdSearch::lanes; ++j) offset_lane(j);
  lanes_.run(local_.graph, sources_, {local_.partition.key, branch_of_, offset_},
             std::span(order_).first(local_.size()));
  laps_.end(seconds_.locked_search);
}

// From a neighbour of the current seed, what is in its subtree is nearer by its distance, and the
// rest farther by that at most. From any other node all may be farther. Idle lanes do as the first.
void RegionRelaxation::offset_lane(std::size_t lane) {
  const NodeId source = sources_[lane < sources_.size() ? lane : 0];
  const std::uint32_t distance = distance_of(local_.partition.key[source]);
  find_branches_below(local_.graph, local_.partition, current_, branch_of_, source, below_);
  for (std::size_t b = 0; b < below_.size(); ++b) {
    offset_[b].d[lane] = below_[b] != 0 ? 0 - distance : distance;
  }
  offset_.back().d[lane] = distance;
}

// Sorts by distance, but for what falls into the same of as many buckets as nodes.
void RegionRelaxation::find_order() {
  const std::vector<Key>& keys = local_.partition.key;
  std::uint32_t bits = 0;
  for (const Key key : keys) bits |= distance_of(key);
  const auto bucket_bits = static_cast<unsigned>(std::bit_width(keys.size()));
  const unsigned shift = std::max<unsigned>(std::bit_width(bits), bucket_bits) - bucket_bits;
  bucket_.assign((std::size_t{1} << bucket_bits) + 1, 0);
  for (const Key key : keys) ++bucket_[(distance_of(key) >> shift) + 1];
  for (std::size_t b = 1; b < bucket_.size(); ++b) bucket_[b] += bucket_[b - 1];
  for (NodeId v = 0; v < keys.size(); ++v) order_[bucket_[distance_of(keys[v]) >> shift]++] = v;
}

}  // namespace geolloyd
