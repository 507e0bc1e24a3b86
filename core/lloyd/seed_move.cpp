#include "core/lloyd/seed_move.h"

#include <limits>

namespace geolloyd {
namespace {

// A heuristic is one weight, and in the extended mode those of subtrees that have no node in
// common: together these have at most all cost and all mass.
static_assert(most_cost <= std::numeric_limits<Uint128>::max() / most_subtree_mass / 2);

Uint128 weight(const SubtreeSums& sums, NodeId v) {
  return Uint128{sums.cost[v]} * sums.mass[v];
}

// The largest heuristic seen, by the smallest node.
struct Best {
  NodeId node = no_id;
  Uint128 value = 0;

  void offer(NodeId v, Uint128 heuristic_value) {
    if (node == no_id || heuristic_value > value) *this = {v, heuristic_value};
  }
};

}  // namespace

Uint128 heuristic(const SeedMoveView& view, NodeId seed, NodeId v) {
  Uint128 value = weight(view.sums, v);
  if (!view.extended) return value;
  for (const NodeId n : view.graph.neighbours(v)) {
    if (view.partition.parent[n] == seed) value += weight(view.sums, n);
  }
  return value;
}

NodeId greedy_candidate(const SeedMoveView& view, NodeId seed) {
  Best best;
  for (const NodeId v : view.graph.neighbours(seed)) {
    if (same_region(view.partition.key, seed, v)) best.offer(v, heuristic(view, seed, v));
  }
  return best.node;
}

NodeId lower_neighbour(const Graph& graph, const std::vector<Key>& keys,
                       std::span<const Score> score, NodeId seed) {
  NodeId lower = no_id;
  Score lowest = score[seed];
  for (const NodeId v : graph.neighbours(seed)) {
    if (score[v] >= lowest || !same_region(keys, seed, v)) continue;
    lower = v;
    lowest = score[v];
  }
  return lower;
}

NodeId precise_candidate(const SeedMoveView& view, std::span<const Score> score, NodeId seed) {
  const NodeId lower = lower_neighbour(view.graph, view.partition.key, score, seed);
  if (lower != no_id) return lower;
  Best unscored;
  for (const NodeId v : view.graph.neighbours(seed)) {
    if (score[v] != never_scored || !same_region(view.partition.key, seed, v)) continue;
    unscored.offer(v, heuristic(view, seed, v));
  }
  return unscored.node;
}

}  // namespace geolloyd
