#pragma once

#include <span>
#include <vector>

#include "core/graph/graph.h"
#include "core/voronoi/indexed_heap.h"
#include "core/voronoi/partition.h"

namespace geolloyd {

/// Multi-source search, regions free (Dijkstra 1959, all seeds in the heap at once). Overwrites
/// `keys` (one per node) and lists in `settled` the reached nodes, in ascending order of key.
/// `seeds` are different nodes. O((nodes + arcs) log nodes).
void search_free(const Graph& graph, std::span<const NodeId> seeds, IndexedHeap& heap,
                 std::vector<Key>& keys, std::vector<NodeId>& settled);

/// The same with regions locked: only the regions in `searched` (no repeats), each from its own
/// seed, over arcs between nodes of the region. Regions are read from `keys`; other keys stay.
void search_locked(const Graph& graph, std::span<const NodeId> seeds,
                   std::span<const RegionId> searched, IndexedHeap& heap, std::vector<Key>& keys,
                   std::vector<NodeId>& settled);

}  // namespace geolloyd
