#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/graph/graph.h"
#include "core/voronoi/partition.h"

namespace geolloyd {

enum class Regions { free, locked };

/// What is wrong with a partition, and where.
struct PartitionDefect {
  NodeId node;
  std::string what;
};

/// Certifies a partition in O(arcs) without searching: no arc can lower a key, and every key but a
/// seed's 0 is reached by its parent's. As lengths are positive, both together leave only the one
/// true answer. Regions locked: the same over arcs inside a region. Returns the first defect.
std::optional<PartitionDefect> check_partition(const Graph& graph, std::span<const NodeId> seeds,
                                               const Partition& partition, Regions regions);

}  // namespace geolloyd
