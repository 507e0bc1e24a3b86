#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "core/graph/graph.h"
#include "core/lloyd/relaxation.h"
#include "core/voronoi/partition.h"

/// The canonical definition (design, section 2) written down a second time, as plainly as possible
/// and without any of the engine's means: no heap, no packed keys in the searching, no order of
/// nodes, no incremental anything. For small graphs.
namespace geolloyd::naive {

/// Lowers keys along arcs until nothing changes (Bellman-Ford). `locked` holds a region per node.
inline Partition partition(const Graph& graph, const std::vector<NodeId>& seeds,
                           const std::optional<std::vector<RegionId>>& locked = {}) {
  using DistanceAndRegion = std::pair<std::uint64_t, std::uint64_t>;
  const DistanceAndRegion none{unreached_distance, no_id};
  std::vector<DistanceAndRegion> label(graph.node_count(), none);
  for (RegionId r = 0; r < seeds.size(); ++r) label[seeds[r]] = {0, r};
  const auto joins = [&](NodeId a, NodeId b) { return !locked || (*locked)[a] == (*locked)[b]; };
  for (bool changed = true; changed;) {
    changed = false;
    for (NodeId v = 0; v < graph.node_count(); ++v) {
      for (ArcId a = graph.first_arc[v]; a < graph.first_arc[v + 1]; ++a) {
        const auto [distance, region] = label[graph.target[a]];
        if (label[graph.target[a]] == none || !joins(v, graph.target[a])) continue;
        const DistanceAndRegion offered{distance + graph.length[a], region};
        if (offered < label[v]) {
          label[v] = offered;
          changed = true;
        }
      }
    }
  }
  Partition result;
  for (NodeId v = 0; v < graph.node_count(); ++v) {
    const auto [distance, region] = label[v];
    result.key.push_back(
        make_key(static_cast<std::uint32_t>(distance), static_cast<RegionId>(region)));
    NodeId parent = no_id;
    for (ArcId a = graph.first_arc[v]; a < graph.first_arc[v + 1]; ++a) {
      const NodeId u = graph.target[a];
      const bool attains = label[u] != none && label[u].second == region &&
                           label[u].first + graph.length[a] == distance;
      if (attains && u < parent) parent = u;
    }
    result.parent.push_back(parent);
  }
  return result;
}

/// cost and mass of the subtree of `v`, by asking every node whether `v` is on its way to the root.
struct Sums {
  std::uint64_t cost = 0;
  std::uint64_t mass = 0;
};
inline Sums subtree(const Graph& graph, const Partition& partition, NodeId v) {
  Sums sums;
  for (NodeId w = 0; w < graph.node_count(); ++w) {
    NodeId up = w;
    while (up != no_id && up != v) up = partition.parent[up];
    if (up != v) continue;
    sums.cost += distance_of(partition.key[w]);
    sums.mass += graph.mass[w];
  }
  return sums;
}

inline Uint128 heuristic(const Graph& graph, const Partition& partition, NodeId seed, NodeId v,
                         bool extended) {
  const auto product = [&](NodeId w) {
    const Sums sums = subtree(graph, partition, w);
    return Uint128{sums.cost} * sums.mass;
  };
  Uint128 value = product(v);
  for (const NodeId n : graph.neighbours(v)) {
    if (extended && partition.parent[n] == seed) value += product(n);
  }
  return value;
}

inline Score score(const Graph& graph, const Partition& partition, RegionId region) {
  Score sum = 0;
  for (NodeId v = 0; v < graph.node_count(); ++v) {
    if (region_of(partition.key[v]) != region) continue;
    const Uint128 distance = distance_of(partition.key[v]);
    sum += distance * distance * graph.mass[v];
  }
  return sum;
}

inline std::vector<NodeId> neighbours_in_region(const Graph& graph, const Partition& partition,
                                                NodeId seed) {
  std::vector<NodeId> found;
  for (const NodeId v : graph.neighbours(seed)) {
    if (region_of(partition.key[v]) == region_of(partition.key[seed])) found.push_back(v);
  }
  return found;
}

/// Of `nodes` (ascending) the one with the largest heuristic, the first of equals.
inline NodeId largest_heuristic(const Graph& graph, const Partition& partition, NodeId seed,
                                const std::vector<NodeId>& nodes, bool extended) {
  NodeId best = no_id;
  for (const NodeId v : nodes) {
    if (best == no_id || heuristic(graph, partition, seed, v, extended) >
                             heuristic(graph, partition, seed, best, extended)) {
      best = v;
    }
  }
  return best;
}

inline NodeId precise_candidate(const Graph& graph, const Partition& partition,
                                const std::map<NodeId, Score>& scores, NodeId seed, bool extended) {
  NodeId lower = no_id;
  Score lowest = scores.at(seed);
  std::vector<NodeId> unscored;
  for (const NodeId v : neighbours_in_region(graph, partition, seed)) {
    if (!scores.contains(v)) {
      unscored.push_back(v);
    } else if (scores.at(v) < lowest) {
      lower = v;
      lowest = scores.at(v);
    }
  }
  if (lower != no_id) return lower;
  return largest_heuristic(graph, partition, seed, unscored, extended);
}

/// What a relaxation went through: the seeds at the start of each step, and at the end.
struct History {
  std::vector<std::vector<NodeId>> greedy;
  std::vector<std::vector<NodeId>> macro;
  std::vector<std::size_t> microsteps;  ///< per macrostep
  std::vector<NodeId> last;
  bool recurred = false;
};

inline std::vector<RegionId> regions_of(const Partition& partition) {
  std::vector<RegionId> regions;
  for (const Key key : partition.key) regions.push_back(region_of(key));
  return regions;
}

inline History relax(const Graph& graph, std::vector<NodeId> seeds,
                     const RelaxationOptions& options) {
  History history;
  const bool extended = options.greedy != GreedyMode::standard;

  std::set<NodeId> has_been_seed;
  for (bool moved = options.greedy != GreedyMode::off; moved;) {
    history.greedy.push_back(seeds);
    const Partition p = partition(graph, seeds);
    has_been_seed.insert(seeds.begin(), seeds.end());
    moved = false;
    for (NodeId& seed : seeds) {
      const NodeId v =
          largest_heuristic(graph, p, seed, neighbours_in_region(graph, p, seed), extended);
      if (v == no_id || has_been_seed.contains(v)) continue;
      seed = v;
      moved = true;
    }
  }

  std::set<std::vector<NodeId>> met;
  std::vector<Score> last_scores;
  while (true) {
    if (!met.insert(seeds).second) {
      history.recurred = true;
      break;
    }
    history.macro.push_back(seeds);
    const std::vector<NodeId> before = seeds;
    const Partition free = partition(graph, seeds);
    const std::vector<RegionId> regions = regions_of(free);
    std::vector<Score> start_scores;
    for (RegionId r = 0; r < seeds.size(); ++r) start_scores.push_back(score(graph, free, r));

    std::map<NodeId, Score> scores;
    std::size_t microsteps = 0;
    for (bool moved = true; moved;) {
      ++microsteps;
      moved = false;
      const Partition p = partition(graph, seeds, regions);
      for (RegionId r = 0; r < seeds.size(); ++r) scores[seeds[r]] = score(graph, p, r);
      for (RegionId r = 0; r < seeds.size(); ++r) {
        const bool kept =
            options.macrostep_skip && !last_scores.empty() && start_scores[r] == last_scores[r];
        if (kept) continue;
        const NodeId v = precise_candidate(graph, p, scores, seeds[r], extended);
        if (v == no_id) continue;
        seeds[r] = v;
        moved = true;
      }
    }
    history.microsteps.push_back(microsteps);
    last_scores = start_scores;
    if (seeds == before) break;
  }
  history.last = seeds;
  return history;
}

/// Of all states of a history that of the lowest score, the first of equals.
inline std::vector<NodeId> best_state(const Graph& graph, const History& history) {
  std::vector<std::vector<NodeId>> states = history.greedy;
  states.insert(states.end(), history.macro.begin(), history.macro.end());
  states.push_back(history.last);
  std::vector<NodeId> best;
  Score lowest = 0;
  for (const std::vector<NodeId>& seeds : states) {
    const Partition p = partition(graph, seeds);
    Score sum = 0;
    for (RegionId r = 0; r < seeds.size(); ++r) sum += score(graph, p, r);
    if (!best.empty() && sum >= lowest) continue;
    best = seeds;
    lowest = sum;
  }
  return best;
}

}  // namespace geolloyd::naive
