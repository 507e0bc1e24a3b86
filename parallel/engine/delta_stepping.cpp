#include "parallel/engine/delta_stepping.h"

#include <algorithm>
#include <atomic>
#include <limits>

#include "core/base/loops.h"
#include "parallel/threads/atomic_key.h"

namespace geolloyd {
namespace {

static_assert(most_arcs <= std::numeric_limits<std::uint64_t>::max() / most_length);

std::uint32_t mean_length(Scheduler& scheduler, const Graph& graph) {
  const auto total = parallel_reduce<std::uint64_t>(scheduler, graph.arc_count(), 1 << 15,
                                                    [&](std::size_t begin, std::size_t end) {
                                                      std::uint64_t sum = 0;
                                                      for (std::size_t a = begin; a < end; ++a)
                                                        sum += graph.length[a];
                                                      return sum;
                                                    });
  return static_cast<std::uint32_t>(total / std::max<std::size_t>(graph.arc_count(), 1));
}

void set(std::uint8_t& flag) {
  const std::atomic_ref shared(flag);
  if (shared.load(std::memory_order_relaxed) == 0) shared.store(1, std::memory_order_relaxed);
}

}  // namespace

DeltaStepping::DeltaStepping(Scheduler& scheduler, const Graph& graph, std::uint32_t delta)
    : scheduler_(scheduler), graph_(graph), delta_(delta), buckets_(scheduler.threads()) {
  // Not so many buckets (2^19 for the farthest node) that they cost more than the nodes, where a
  // few arcs are very long.
  constexpr std::uint32_t least = 1 << 12;
  if (delta_ == 0) delta_ = std::max(mean_length(scheduler, graph), least);
}

void DeltaStepping::Buckets::clear() {
  for (std::size_t b = first; b < end; ++b) at[b].clear();
  first = no_id;
  end = 0;
  frontier.clear();
  lowered.clear();
}

// An exception may have left something in them.
void DeltaStepping::begin() {
  keeps_buckets_ = true;
  for (Buckets& b : buckets_) b.clear();
}

void DeltaStepping::search(std::span<const NodeId> seeds, std::vector<Key>& keys) {
  begin();
  keys.assign(graph_.node_count(), unreached);
  for (RegionId r = 0; r < seeds.size(); ++r) {
    keys[seeds[r]] = make_key(0, r);
    buckets_.front().push(0, {keys[seeds[r]], seeds[r]});
  }
  keeps_buckets_ = false;
  settle(keys, [](Buckets&, NodeId, Key, Key) {});
  release_memory();
}

void DeltaStepping::release_memory() {
  for (Buckets& b : buckets_) b = {};
}

void DeltaStepping::repair(const RegionNodes& region_nodes, std::span<const RegionSlice> suspects,
                           std::vector<Key>& keys, std::vector<std::uint8_t>& is_changed) {
  begin();
  const auto note_change = [&](Buckets&, NodeId, Key before, Key after) {
    if (before != unreached) set(is_changed[region_of(before)]);
    set(is_changed[region_of(after)]);
  };
  parallel_for_ranges(scheduler_, suspects.size(), grain_of(suspects),
                      [&](std::size_t begin, std::size_t end, std::size_t worker) {
                        for (std::size_t i = begin; i < end; ++i) {
                          examine_slice(region_nodes, suspects[i], keys, buckets_[worker],
                                        note_change);
                        }
                      });
  settle(keys, note_change);
}

void DeltaStepping::lower_from(std::span<const NodeId> sources, std::vector<Key>& keys) {
  constexpr std::size_t grain = 1 << 12;
  begin();
  const auto ignore = [](Buckets&, NodeId, Key, Key) {};
  parallel_for_ranges(scheduler_, sources.size(), grain,
                      [&](std::size_t begin, std::size_t end, std::size_t worker) {
                        for (std::size_t i = begin; i < end; ++i) {
                          const Key own = load_key(keys[sources[i]]);
                          offer_all(sources[i], own, keys, buckets_[worker], ignore);
                        }
                      });
  settle(keys, ignore);
}

// Most seeds of many are near to few nodes: one thread does these before others would be awake.
void DeltaStepping::add_seed(NodeId seed, RegionId region, std::vector<Key>& keys,
                             std::vector<NodeId>& nearer) {
  constexpr std::size_t few = 1 << 14;
  const auto note = [](Buckets& mine, NodeId v, Key, Key) { mine.lowered.push_back(v); };
  begin();
  Buckets& mine = buckets_.front();
  keys[seed] = make_key(0, region);
  mine.lowered.push_back(seed);
  mine.push(0, {keys[seed], seed});
  for (std::size_t b = 0; b < mine.end && mine.lowered.size() < few; ++b) {
    relax_alone(b, keys, mine, few, note);
  }
  settle(keys, note);
  for (Buckets& b : buckets_) {
    nearer.insert(nearer.end(), b.lowered.begin(), b.lowered.end());
    b.lowered.clear();
  }
}

template <class OnLowered>
void DeltaStepping::settle(std::vector<Key>& keys, OnLowered&& on_lowered) {
  constexpr std::size_t grain = 256;
  constexpr std::size_t few = 1024;  // more than these go back to all threads
  for (std::size_t bucket = take_next_bucket(0); bucket != no_id;
       bucket = take_next_bucket(bucket)) {
    parallel_for_ranges(scheduler_, frontier_size(), grain,
                        [&](std::size_t begin, std::size_t end, std::size_t worker) {
                          Buckets& mine = buckets_[worker];
                          for_each_of_frontier(begin, end, [&](const Entry& entry) {
                            relax(entry, keys, mine, on_lowered);
                          });
                          relax_alone(bucket, keys, mine, few, on_lowered);
                        });
  }
}

// Goes on with one bucket of a thread while fewer than `few` refill it.
template <class OnLowered>
void DeltaStepping::relax_alone(std::size_t bucket, std::vector<Key>& keys, Buckets& mine,
                                std::size_t few, OnLowered&& on_lowered) {
  while (bucket < mine.end && !mine.at[bucket].empty() && mine.at[bucket].size() < few) {
    mine.again.clear();
    mine.again.swap(mine.at[bucket]);
    for (const Entry& entry : mine.again) relax(entry, keys, mine, on_lowered);
  }
}

template <class OnLowered>
void DeltaStepping::relax(const Entry& entry, std::vector<Key>& keys, Buckets& mine,
                          OnLowered&& on_lowered) {
  const auto [key, v] = entry;
  if (load_key(keys[v]) == key) offer_all(v, key, keys, mine, on_lowered);
}

template <class OnLowered>
void DeltaStepping::offer_all(NodeId v, Key own, std::vector<Key>& keys, Buckets& mine,
                              OnLowered&& on_lowered) {
  for (ArcId a = graph_.first_arc[v]; a < graph_.first_arc[v + 1]; ++a) {
    const NodeId u = graph_.target[a];
    const Key offered = along(own, graph_.length[a]);
    const Key before = lower_key(keys[u], offered);
    if (offered >= before) continue;
    on_lowered(mine, u, before, offered);
    mine.push(bucket_of(offered), {offered, u});
    prefetch_arcs(graph_, u);
  }
}

// Around a region that is one slice, all that follows is done at once, while it is in the cache; of
// larger ones it is left to all threads.
template <class OnLowered>
void DeltaStepping::examine_slice(const RegionNodes& region_nodes, const RegionSlice& slice,
                                  std::vector<Key>& keys, Buckets& mine, OnLowered&& on_lowered) {
  for (const NodeId v : nodes_of(region_nodes, slice)) examine(v, keys, mine, on_lowered);
  if (!is_whole(region_nodes, slice)) return;
  for (std::size_t bucket = mine.first; bucket < mine.end; ++bucket) {
    relax_alone(bucket, keys, mine, no_id, on_lowered);
  }
  mine.first = no_id;
  mine.end = 0;
}

// Offers to and from a node that may be lowered, or may lower others.
template <class OnLowered>
void DeltaStepping::examine(NodeId v, std::vector<Key>& keys, Buckets& mine,
                            OnLowered&& on_lowered) {
  const Key own = load_key(keys[v]);
  Key lowest = own;
  for (ArcId a = graph_.first_arc[v]; a < graph_.first_arc[v + 1]; ++a) {
    const NodeId u = graph_.target[a];
    const Key key = load_key(keys[u]);
    if (key != unreached) lowest = std::min(lowest, along(key, graph_.length[a]));
    const Key offered = along(own, graph_.length[a]);
    if (own == unreached || offered >= key) continue;
    const Key before = lower_key(keys[u], offered);
    if (offered >= before) continue;
    on_lowered(mine, u, before, offered);
    mine.push(bucket_of(offered), {offered, u});
  }
  if (lowest >= own) return;
  const Key before = lower_key(keys[v], lowest);
  if (lowest >= before) return;
  on_lowered(mine, v, before, lowest);
  mine.push(bucket_of(lowest), {lowest, v});
}

// The entries of all threads as one row, which nobody has to copy together.
std::size_t DeltaStepping::frontier_size() const {
  std::size_t size = 0;
  for (const Buckets& b : buckets_) size += b.frontier.size();
  return size;
}

template <class Visit>
void DeltaStepping::for_each_of_frontier(std::size_t begin, std::size_t end, Visit&& visit) const {
  std::size_t first = 0;  // of this thread's, in the row
  for (const Buckets& b : buckets_) {
    const std::size_t last = first + b.frontier.size();
    for (std::size_t i = std::max(begin, first); i < std::min(end, last); ++i) {
      visit(b.frontier[i - first]);
    }
    first = last;
  }
}

// Moves the first bucket that is not empty, from this one on, to the frontier; no_id where all are
// empty.
std::size_t DeltaStepping::take_next_bucket(std::size_t bucket) {
  std::size_t next = no_id;
  for (const Buckets& b : buckets_) {
    for (std::size_t i = std::max(bucket, b.first); i < std::min(b.end, next); ++i) {
      if (!b.at[i].empty()) next = i;
    }
  }
  for (Buckets& b : buckets_) {
    b.frontier.clear();
    if (next >= b.end) {  // all are empty
      b.first = no_id;
      b.end = 0;
      continue;
    }
    b.first = next;
    b.frontier.swap(b.at[next]);
    if (!keeps_buckets_) b.at[next].shrink_to_fit();
  }
  return next;
}

}  // namespace geolloyd
