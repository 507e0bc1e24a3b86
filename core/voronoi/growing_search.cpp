#include "core/voronoi/growing_search.h"

#include "core/voronoi/indexed_heap.h"

namespace geolloyd {
namespace {

class HeapSearch final : public GrowingSearch {
 public:
  explicit HeapSearch(const Graph& graph)
      : graph_(graph), heap_(graph.node_count()), keys_(graph.node_count(), unreached) {}

  std::span<const NodeId> add(NodeId seed) override {
    nearer_.clear();
    keys_[seed] = make_key(0, seeds_++);
    heap_.push_or_decrease(seed, keys_[seed]);
    while (!heap_.empty()) {
      const NodeId v = heap_.pop();
      nearer_.push_back(v);
      for (ArcId a = graph_.first_arc[v]; a < graph_.first_arc[v + 1]; ++a) {
        const NodeId u = graph_.target[a];
        const Key offered = along(keys_[v], graph_.length[a]);
        if (offered >= keys_[u]) continue;
        keys_[u] = offered;
        heap_.push_or_decrease(u, offered);
      }
    }
    return nearer_;
  }

  [[nodiscard]] const std::vector<Key>& keys() const override { return keys_; }

 private:
  const Graph& graph_;
  IndexedHeap heap_;
  std::vector<Key> keys_;
  std::vector<NodeId> nearer_;
  RegionId seeds_ = 0;
};

}  // namespace

std::unique_ptr<GrowingSearch> make_growing_search(const Graph& graph) {
  return std::make_unique<HeapSearch>(graph);
}

}  // namespace geolloyd
