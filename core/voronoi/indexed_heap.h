#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/voronoi/partition.h"

namespace geolloyd {

/// Binary min-heap of nodes by key, with decrease-key. Takes memory once, for all nodes of a graph;
/// empty again after as many pops as pushes.
class IndexedHeap {
 public:
  explicit IndexedHeap(std::size_t node_count) : slot_of_(node_count, no_id) {}

  [[nodiscard]] bool empty() const { return entries_.empty(); }

  /// Adds `node`, or lowers its key if it is in the heap; `key` must be lower then.
  void push_or_decrease(NodeId node, Key key) {
    std::uint32_t slot = slot_of_[node];
    if (slot == no_id) {
      slot = static_cast<std::uint32_t>(entries_.size());
      entries_.emplace_back();
    }
    rise(slot, {key, node});
  }

  /// Removes and returns the node of the smallest key. Equal keys leave in no particular order.
  NodeId pop() {
    const NodeId top = entries_.front().node;
    slot_of_[top] = no_id;
    const Entry last = entries_.back();
    entries_.pop_back();
    if (!entries_.empty()) sink(last);
    return top;
  }

 private:
  struct Entry {
    Key key;
    NodeId node;
  };

  void place(std::uint32_t slot, const Entry& entry) {
    entries_[slot] = entry;
    slot_of_[entry.node] = slot;
  }

  void rise(std::uint32_t slot, const Entry& entry) {
    while (slot > 0) {
      const std::uint32_t above = (slot - 1) / 2;
      if (entries_[above].key <= entry.key) break;
      place(slot, entries_[above]);
      slot = above;
    }
    place(slot, entry);
  }

  void sink(const Entry& entry) {
    const auto size = static_cast<std::uint32_t>(entries_.size());
    std::uint32_t slot = 0;
    for (std::uint32_t below = 1; below < size; below = 2 * slot + 1) {
      if (below + 1 < size && entries_[below + 1].key < entries_[below].key) ++below;
      if (entry.key <= entries_[below].key) break;
      place(slot, entries_[below]);
      slot = below;
    }
    place(slot, entry);
  }

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> slot_of_;  // per node; no_id while it is not in the heap
};

}  // namespace geolloyd
