#include "core/seed_move.h"

namespace geolloyd {
namespace {

bool same_region(const Partition& partition, NodeId a, NodeId b) {
  return region_of(partition.key[a]) == region_of(partition.key[b]);
}

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
    if (same_region(view.partition, seed, v)) best.offer(v, heuristic(view, seed, v));
  }
  return best.node;
}

NodeId precise_candidate(const SeedMoveView& view, std::span<const Score> score, NodeId seed) {
  NodeId lower = no_id;
  Score lowest = score[seed];
  Best unscored;
  for (const NodeId v : view.graph.neighbours(seed)) {
    if (!same_region(view.partition, seed, v)) continue;
    if (score[v] < lowest) {
      lower = v;
      lowest = score[v];
    } else if (score[v] == never_scored && lower == no_id) {
      unscored.offer(v, heuristic(view, seed, v));
    }
  }
  return lower != no_id ? lower : unscored.node;
}

}  // namespace geolloyd
