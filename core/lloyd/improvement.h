#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/graph/graph.h"
#include "core/voronoi/energy.h"
#include "core/voronoi/partition.h"

namespace geolloyd {

/// A partition, regions free, with its seeds and scores, one per region.
struct ScoredPartition {
  std::vector<NodeId> seeds;
  std::vector<Key> key;  ///< per node
  std::vector<Score> scores;
};

/// Seeds to relax from, in the hope for a lower minimum than that of `base`. Some seeds move from
/// where regions cost least to where regions cost twice as much and more. Elsewhere some seeds,
/// two regions or more apart, move to a random place in their region; regions without six
/// neighbours come first. Random numbers go by `round`. Different nodes; each component keeps a
/// seed.
std::vector<NodeId> perturb(const Graph& graph, const ScoredPartition& base, std::uint64_t round);

/// Clusters are regions between which nodes changed hands from `base` to `other`. No node outside
/// of a cluster has noticed it, so each cluster can have the seeds of that partition in which its
/// score is lower: those of `base` among equals. Together they cost no more than either partition.
/// Returns, per region, not 0 where the seed is to be that of `other`.
std::vector<std::uint8_t> lower_clusters(const ScoredPartition& base, const ScoredPartition& other);

}  // namespace geolloyd
