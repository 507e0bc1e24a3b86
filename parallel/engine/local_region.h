#pragma once

#include <span>
#include <vector>

#include "core/graph/graph.h"
#include "core/voronoi/partition.h"

namespace geolloyd {

/// One locked region as a graph of its own: its nodes, numbered in their order, and the arcs
/// between them. Small and compact, so that all work on it stays in the cache; ties come out as in
/// the whole graph. Its memory is reused from region to region.
struct LocalRegion {
  Graph graph;
  std::vector<NodeId> node;  ///< per local node: its number in the whole graph, ascending
  Partition partition;       ///< keys of region 0, parents as far as somebody derives them

  [[nodiscard]] std::size_t size() const { return node.size(); }
};

/// Copies the region that consists of `nodes`. `keys` are those of the whole graph; other threads
/// may be writing the distances, but not the regions, of other nodes. `local_of`, one per node of
/// the whole graph, is used at `nodes` only.
void copy_region(const Graph& graph, const std::vector<Key>& keys, std::span<const NodeId> nodes,
                 std::vector<NodeId>& local_of, LocalRegion& local);

}  // namespace geolloyd
