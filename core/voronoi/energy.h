#pragma once

#include <limits>
#include <span>
#include <vector>

#include "core/graph/graph.h"
#include "core/voronoi/partition.h"

namespace geolloyd {

/// Sum over a region of distance^2 * mass, in ticks; below 2^124.
using Score = Uint128;
/// Of a node that has not been the seed since scores were last forgotten.
inline constexpr Score never_scored = std::numeric_limits<Score>::max();

/// Share of a node in the score of its region.
inline Score node_score(std::uint64_t distance, std::uint32_t mass) {
  const std::uint64_t squared = distance * distance;
  return Uint128{squared} * mass;
}

/// Adds distance^2 * mass of each of `nodes` to the score of its region. Exact; order is free.
inline void add_scores(const Graph& graph, const std::vector<Key>& keys,
                       std::span<const NodeId> nodes, std::span<Score> region_score) {
  for (const NodeId v : nodes) {
    region_score[region_of(keys[v])] += node_score(distance_of(keys[v]), graph.mass[v]);
  }
}

static_assert(Score{most_distance} * most_distance < (never_scored / most_mass / most_nodes),
              "the score of all nodes at once fits, and is no mark");

/// A score, or a sum of scores, in mesh units: sum of mass * distance^2.
inline double to_energy(const Graph& graph, Score score) {
  return static_cast<double>(score) * graph.tick_length * graph.tick_length * graph.tick_mass;
}

}  // namespace geolloyd
