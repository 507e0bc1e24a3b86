#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/graph/graph.h"
#include "core/voronoi/partition.h"
#include "parallel/engine/region_nodes.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {

/// Finds partitions by delta-stepping (Meyer, Sanders 2003): nodes within `delta` ticks of distance
/// are relaxed together, each thread collecting what it lowers in buckets of its own, and going on
/// by itself while a bucket it refills is small (bucket fusion: Zhang et al., CGO 2020; GAP
/// benchmark suite). Keys are lowered by atomic minimum; there is only one state where no
/// arc can lower any more, so no order of work can change it. Keeps its memory between searches.
class DeltaStepping {
 public:
  /// `delta` 0: about one mean arc.
  DeltaStepping(Scheduler& scheduler, const Graph& graph, std::uint32_t delta = 0);

  /// From scratch: overwrites `keys`, one per node, with what search_free (dijkstra.h) gives. All
  /// nodes pass through the buckets, so each gives its memory back once it is done.
  void search(std::span<const NodeId> seeds, std::vector<Key>& keys);

  /// From `keys` that are upper bounds of the final keys: 0 at seeds, and to be lowered by no arc
  /// but those at nodes of the `suspects`. Regions may also be locked ones, of a graph that has no
  /// arcs between them. Sets `is_changed` of each region that a node of it changed in, left or
  /// joined.
  void repair(const RegionNodes& region_nodes, std::span<const RegionSlice> suspects,
              std::vector<Key>& keys, std::vector<std::uint8_t>& is_changed);

  /// From `keys` that are such bounds, to be lowered by no arc but those that leave `sources`.
  void lower_from(std::span<const NodeId> sources, std::vector<Key>& keys);

  /// Of `keys` that are a partition already: lowers those nearer to `seed`, a new region's, and
  /// adds them to `nearer`, maybe more than once.
  void add_seed(NodeId seed, RegionId region, std::vector<Key>& keys, std::vector<NodeId>& nearer);

 private:
  // A node and the key it was lowered to: out of date once it has been lowered again.
  struct Entry {
    Key key;
    NodeId node;
  };

  // What one thread has lowered, by distance / delta. On a line of its own in the cache.
  struct alignas(64) Buckets {
    std::vector<std::vector<Entry>> at;
    std::size_t first = no_id;    // of those in use
    std::size_t end = 0;          // of those in use
    std::vector<Entry> frontier;  // being relaxed by all threads, with those of the others
    std::vector<Entry> again;     // being relaxed alone
    std::vector<NodeId> lowered;  // as far as somebody wants to know

    void push(std::size_t bucket, const Entry& entry) {
      if (at.size() <= bucket) at.resize(bucket + 1);
      at[bucket].push_back(entry);
      first = std::min(first, bucket);
      end = std::max(end, bucket + 1);
    }
    void clear();
  };

  [[nodiscard]] std::size_t bucket_of(Key key) const { return distance_of(key) / delta_; }

  void begin();
  template <class OnLowered>
  void settle(std::vector<Key>& keys, OnLowered&& on_lowered);
  template <class OnLowered>
  void relax(const Entry& entry, std::vector<Key>& keys, Buckets& mine, OnLowered&& on_lowered);
  template <class OnLowered>
  void relax_alone(std::size_t bucket, std::vector<Key>& keys, Buckets& mine, std::size_t few,
                   OnLowered&& on_lowered);
  template <class OnLowered>
  void examine_slice(const RegionNodes& region_nodes, const RegionSlice& slice,
                     std::vector<Key>& keys, Buckets& mine, OnLowered&& on_lowered);
  template <class OnLowered>
  void examine(NodeId v, std::vector<Key>& keys, Buckets& mine, OnLowered&& on_lowered);
  template <class OnLowered>
  void offer_all(NodeId v, Key own, std::vector<Key>& keys, Buckets& mine, OnLowered&& on_lowered);
  std::size_t take_next_bucket(std::size_t bucket);
  void release_memory();
  [[nodiscard]] std::size_t frontier_size() const;
  template <class Visit>
  void for_each_of_frontier(std::size_t begin, std::size_t end, Visit&& visit) const;

  Scheduler& scheduler_;
  const Graph& graph_;
  std::uint32_t delta_;
  std::vector<Buckets> buckets_;  // per thread
  bool keeps_buckets_ = true;     // the memory of those that are done
};

}  // namespace geolloyd
