#pragma once

#include <span>
#include <vector>

#include "core/base/bucketing.h"
#include "core/graph/graph.h"
#include "core/graph/ticks.h"

namespace geolloyd {

/// An arc at one of its ends: the target in the high half, so that a row sorts by it, and in the
/// low half the index of the undirected arc whose length it has.
using PlacedArc = std::uint64_t;

inline NodeId target_of(PlacedArc arc) {
  return static_cast<NodeId>(arc >> 32);
}
inline double length_of(PlacedArc arc, std::span<const UndirectedArc> arcs) {
  return arcs[static_cast<std::uint32_t>(arc)].length;
}

/// The rows of a graph to be. Each row is sorted by target; of arcs to one target only the shortest
/// is left.
struct SortedRows {
  Bucketed<PlacedArc> placed;    ///< per node, the row in front
  std::vector<ArcId> first_arc;  ///< per node, and one more: where the row will stand

  [[nodiscard]] std::size_t node_count() const { return placed.size(); }
  [[nodiscard]] std::span<const PlacedArc> row(NodeId node) const {
    return placed[node].first(first_arc[node + 1] - first_arc[node]);
  }
  [[nodiscard]] std::span<PlacedArc> row(NodeId node) {
    return placed[node].first(first_arc[node + 1] - first_arc[node]);
  }
};

SortedRows sort_rows(std::span<const UndirectedArc> arcs, std::size_t nodes, Executor& executor);

/// Depth of a breadth-first tree of each component, the largest of all. No shortest path is longer
/// than twice that: it could go by the root.
Depth tree_depth(const SortedRows& rows, std::span<const UndirectedArc> arcs);

}  // namespace geolloyd
