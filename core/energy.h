#pragma once

#include <span>
#include <vector>

#include "core/graph.h"
#include "core/partition.h"
#include "core/seed_move.h"

namespace geolloyd {

/// Adds distance^2 * mass of each of `nodes` to the score of its region. Exact; order is free.
inline void add_scores(const Graph& graph, const std::vector<Key>& keys,
                       std::span<const NodeId> nodes, std::span<Score> region_score) {
  for (const NodeId v : nodes) {
    const std::uint64_t distance = distance_of(keys[v]);
    const std::uint64_t squared = distance * distance;
    region_score[region_of(keys[v])] += Uint128{squared} * graph.mass[v];
  }
}

/// A score, or a sum of scores, in mesh units: sum of mass * distance^2.
inline double to_energy(const Graph& graph, Score score) {
  return static_cast<double>(score) * graph.tick_length * graph.tick_length * graph.tick_mass;
}

}  // namespace geolloyd
