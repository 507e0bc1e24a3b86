#include "parallel/repair.h"

#include <atomic>

#include "parallel/atomic_key.h"
#include "parallel/primitives.h"

namespace geolloyd {
namespace {

class Repairer {
 public:
  Repairer(const Graph& graph, std::vector<Key>& keys, std::vector<std::uint8_t>& is_dirty)
      : graph_(graph), keys_(keys), is_dirty_(is_dirty) {}

  // Offers to and from a node that may be lowered, or lower others.
  void examine(NodeId v) {
    Key key = load_key(keys_[v]);
    for (ArcId a = graph_.first_arc[v]; a < graph_.first_arc[v + 1]; ++a) {
      const Key from = load_key(keys_[graph_.target[a]]);
      if (from == unreached) continue;
      const Key offered = along(from, graph_.length[a]);
      if (offered >= key) continue;
      lower(v, offered);
      key = offered;
    }
    relax(v);
  }

  void relax_all_queued() {
    for (std::size_t i = 0; i < queue_.size(); ++i) relax(queue_[i]);
    queue_.clear();
  }

 private:
  void relax(NodeId v) {
    const Key key = load_key(keys_[v]);
    if (key == unreached) return;
    for (ArcId a = graph_.first_arc[v]; a < graph_.first_arc[v + 1]; ++a) {
      const NodeId u = graph_.target[a];
      const Key offered = along(key, graph_.length[a]);
      if (offered < load_key(keys_[u]) && lower(u, offered)) queue_.push_back(u);
    }
  }

  bool lower(NodeId v, Key offered) {
    const Key before = lower_key(keys_[v], offered);
    if (offered >= before) return false;
    mark_dirty(region_of(offered));
    if (before != unreached) mark_dirty(region_of(before));
    return true;
  }

  void mark_dirty(RegionId r) {
    const std::atomic_ref flag(is_dirty_[r]);
    if (flag.load(std::memory_order_relaxed) == 0) flag.store(1, std::memory_order_relaxed);
  }

  const Graph& graph_;
  std::vector<Key>& keys_;
  std::vector<std::uint8_t>& is_dirty_;
  std::vector<NodeId> queue_;
};

}  // namespace

void repair(Scheduler& scheduler, const Graph& graph, const Members& members,
            std::span<const Piece> suspects, std::vector<Key>& keys,
            std::vector<std::uint8_t>& is_dirty) {
  std::vector<Repairer> repairers(scheduler.threads(), Repairer(graph, keys, is_dirty));
  for_ranges(scheduler, suspects.size(), 1,
             [&](std::size_t begin, std::size_t end, std::size_t worker) {
               Repairer& mine = repairers[worker];
               for (std::size_t i = begin; i < end; ++i) {
                 for (NodeId m = suspects[i].begin; m < suspects[i].end; ++m) {
                   mine.examine(members.node[m]);
                 }
               }
               mine.relax_all_queued();
             });
}

}  // namespace geolloyd
