#include "parallel/delta_stepping.h"

#include <algorithm>

#include "parallel/atomic_key.h"
#include "parallel/primitives.h"

namespace geolloyd {
namespace {

// What one thread has lowered, by distance / delta. On a line of its own in the cache.
struct alignas(64) Buckets {
  std::vector<std::vector<NodeId>> at;
  std::vector<NodeId> again;  // being relaxed alone

  void push(std::size_t bucket, NodeId v) {
    if (at.size() <= bucket) at.resize(bucket + 1);
    at[bucket].push_back(v);
  }
};

class DeltaStepping {
 public:
  DeltaStepping(Scheduler& scheduler, const Graph& graph, std::uint32_t delta,
                std::vector<Key>& keys)
      : scheduler_(scheduler),
        graph_(graph),
        delta_(delta),
        keys_(keys),
        buckets_(scheduler.threads()) {}

  void run(std::span<const NodeId> seeds) {
    for (RegionId r = 0; r < seeds.size(); ++r) keys_[seeds[r]] = make_key(0, r);
    frontier_.assign(seeds.begin(), seeds.end());
    for (std::size_t bucket = 0; !frontier_.empty(); bucket = take_next_bucket(bucket)) {
      for_ranges(scheduler_, frontier_.size(), grain,
                 [&](std::size_t begin, std::size_t end, std::size_t worker) {
                   Buckets& mine = buckets_[worker];
                   for (std::size_t i = begin; i < end; ++i) relax(frontier_[i], bucket, mine);
                   go_on_alone(bucket, mine);
                 });
    }
  }

 private:
  static constexpr std::size_t grain = 256;

  [[nodiscard]] std::size_t bucket_of(Key key) const { return distance_of(key) / delta_; }

  // An entry whose node has come to lie in an earlier bucket is out of date: it was relaxed there.
  void relax(NodeId v, std::size_t bucket, Buckets& mine) {
    const Key key = load_key(keys_[v]);
    if (bucket_of(key) < bucket) return;
    for (ArcId a = graph_.first_arc[v]; a < graph_.first_arc[v + 1]; ++a) {
      const NodeId u = graph_.target[a];
      const Key offered = along(key, graph_.length[a]);
      if (offered < lower_key(keys_[u], offered)) mine.push(bucket_of(offered), u);
    }
  }

  // More than a few go back to all threads.
  void go_on_alone(std::size_t bucket, Buckets& mine) {
    constexpr std::size_t few = 1024;
    while (bucket < mine.at.size() && !mine.at[bucket].empty() && mine.at[bucket].size() < few) {
      mine.again.clear();
      mine.again.swap(mine.at[bucket]);
      for (const NodeId v : mine.again) relax(v, bucket, mine);
    }
  }

  // Moves the first bucket not empty, from this one on, to the frontier; returns its number.
  std::size_t take_next_bucket(std::size_t bucket) {
    std::size_t next = no_id;
    for (const Buckets& b : buckets_) {
      for (std::size_t i = bucket; i < std::min(b.at.size(), next); ++i) {
        if (!b.at[i].empty()) next = i;
      }
    }
    frontier_.clear();
    for (Buckets& b : buckets_) {
      if (next >= b.at.size()) continue;
      frontier_.insert(frontier_.end(), b.at[next].begin(), b.at[next].end());
      std::vector<NodeId>().swap(b.at[next]);
    }
    return next;
  }

  Scheduler& scheduler_;
  const Graph& graph_;
  std::uint32_t delta_;
  std::vector<Key>& keys_;
  std::vector<Buckets> buckets_;
  std::vector<NodeId> frontier_;
};

}  // namespace

std::uint32_t suitable_delta(Scheduler& scheduler, const Graph& graph) {
  const auto total = sum_ranges<std::uint64_t>(scheduler, graph.arc_count(), 1 << 15,
                                               [&](std::size_t begin, std::size_t end) {
                                                 std::uint64_t sum = 0;
                                                 for (std::size_t a = begin; a < end; ++a)
                                                   sum += graph.length[a];
                                                 return sum;
                                               });
  const std::uint64_t mean = graph.arc_count() == 0 ? 0 : total / graph.arc_count();
  // Few enough buckets even where a few arcs are much longer than most.
  constexpr std::uint64_t least = 1 << 12;
  return static_cast<std::uint32_t>(std::max(mean, least));
}

void search_free(Scheduler& scheduler, const Graph& graph, std::span<const NodeId> seeds,
                 std::uint32_t delta, std::vector<Key>& keys) {
  keys.assign(graph.node_count(), unreached);
  DeltaStepping(scheduler, graph, delta, keys).run(seeds);
}

}  // namespace geolloyd
