#include "parallel/engine/parallel_growing_search.h"

#include "parallel/engine/delta_stepping.h"

namespace geolloyd {
namespace {

class DeltaSearch final : public GrowingSearch {
 public:
  DeltaSearch(Scheduler& scheduler, const Graph& graph)
      : delta_stepping_(scheduler, graph), keys_(graph.node_count(), unreached) {}

  std::span<const NodeId> add(NodeId seed) override {
    nearer_.clear();
    delta_stepping_.add_seed(seed, seeds_++, keys_, nearer_);
    return nearer_;
  }

  [[nodiscard]] const std::vector<Key>& keys() const override { return keys_; }

 private:
  DeltaStepping delta_stepping_;
  std::vector<Key> keys_;
  std::vector<NodeId> nearer_;
  RegionId seeds_ = 0;
};

}  // namespace

std::unique_ptr<GrowingSearch> make_parallel_growing_search(Scheduler& scheduler,
                                                            const Graph& graph) {
  return std::make_unique<DeltaSearch>(scheduler, graph);
}

}  // namespace geolloyd
