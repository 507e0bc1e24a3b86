#include "core/voronoi/dijkstra.h"

#include <algorithm>

namespace geolloyd {
namespace {

// Settles what is in the heap and all it leads to, by arcs that `may_enter` a node.
template <class MayEnter>
void settle(const Graph& graph, IndexedHeap& heap, std::vector<Key>& keys,
            std::vector<NodeId>& settled, MayEnter&& may_enter) {
  settled.clear();
  while (!heap.empty()) {
    const NodeId v = heap.pop();
    settled.push_back(v);
    const Key key = keys[v];
    for (ArcId a = graph.first_arc[v]; a < graph.first_arc[v + 1]; ++a) {
      const NodeId u = graph.target[a];
      const Key offered = along(key, graph.length[a]);
      if (offered < keys[u] && may_enter(u, key)) {
        keys[u] = offered;
        heap.push_or_decrease(u, offered);
      }
    }
  }
}

}  // namespace

void search_free(const Graph& graph, std::span<const NodeId> seeds, IndexedHeap& heap,
                 std::vector<Key>& keys, std::vector<NodeId>& settled) {
  keys.assign(graph.node_count(), unreached);
  for (RegionId r = 0; r < seeds.size(); ++r) {
    keys[seeds[r]] = make_key(0, r);
    heap.push_or_decrease(seeds[r], keys[seeds[r]]);
  }
  settle(graph, heap, keys, settled, [](NodeId, Key) { return true; });
}

void search_locked(const Graph& graph, std::span<const NodeId> seeds,
                   std::span<const RegionId> searched, IndexedHeap& heap, std::vector<Key>& keys,
                   std::vector<NodeId>& settled) {
  std::vector<bool> is_searched(seeds.size(), false);
  for (const RegionId r : searched) is_searched[r] = true;
  for (Key& key : keys) {
    if (key != unreached && is_searched[region_of(key)]) {
      key = make_key(unreached_distance, region_of(key));
    }
  }
  for (const RegionId r : searched) {
    keys[seeds[r]] = make_key(0, r);
    heap.push_or_decrease(seeds[r], keys[seeds[r]]);
  }
  settle(graph, heap, keys, settled,
         [&](NodeId u, Key from) { return region_of(keys[u]) == region_of(from); });
}

}  // namespace geolloyd
