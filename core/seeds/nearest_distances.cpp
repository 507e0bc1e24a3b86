#include "core/seeds/nearest_distances.h"

#include <bit>
#include <limits>

#include "core/base/huge_pages.h"
#include "core/base/loops.h"

namespace geolloyd {
namespace {

constexpr std::uint32_t unreached = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t block_grain = 1 << 11;

// Of a sample: the width decides how fast a search is, and nothing else. Buckets are not so many
// (2^18 for the farthest node) that they cost more than the nodes, where a few arcs are very long.
unsigned suited_width_bits(const Graph& graph) {
  constexpr std::size_t sample = 1 << 14;
  constexpr int least = 12;
  const std::size_t step = graph.arc_count() / sample + 1;
  std::uint64_t sum = 0;
  std::uint64_t count = 0;
  for (std::size_t a = 0; a < graph.arc_count(); a += step, ++count) sum += graph.length[a];
  const auto width = static_cast<int>(std::bit_width(sum / std::max<std::uint64_t>(count, 1)));
  return static_cast<unsigned>(std::max(width - 1, least));
}

}  // namespace

NearestDistances::NearestDistances(const Graph& graph, Executor& executor)
    : graph_(graph),
      executor_(executor),
      is_shared_(executor.threads() > 1),
      width_bits_(suited_width_bits(graph)),
      distance_(huge_vector<std::uint32_t>(graph.node_count())),
      largest_((graph.node_count() + block_size - 1) / block_size, 0),
      is_stale_(largest_.size(), 0),
      buckets_(executor.threads(), DistanceBuckets(width_bits_)) {}

void NearestDistances::enter(std::span<const NodeId> nodes) {
  nodes_ = nodes;
  block_.clear();
  for (const NodeId v : nodes) {
    distance_[v] = unreached;
    const auto block = static_cast<std::uint32_t>(v / block_size);
    if (block_.empty() || block_.back() != block) block_.push_back(block);
    is_stale_[block] = 1;
  }
}

void NearestDistances::leave() {
  for (const NodeId v : nodes_) distance_[v] = 0;
}

void NearestDistances::add(std::span<const NodeId> sources) {
  constexpr std::size_t grain = 512;  // more than these are shared among threads
  for (DistanceBuckets& b : buckets_) b.clear();
  for (const NodeId v : sources) {
    lower(v, 0);
    buckets_.front().push({v, 0});
  }
  for (std::size_t bucket = 0;; ++bucket) {
    std::size_t next = no_id;
    for (const DistanceBuckets& b : buckets_) {
      const std::size_t first = b.first_from(bucket);
      if (first < b.end()) next = std::min(next, first);
    }
    if (next == no_id) return;
    bucket = next;
    frontier_.clear();
    for (DistanceBuckets& b : buckets_) b.take(bucket, frontier_);
    while (!frontier_.empty()) {
      parallel_for_ranges(executor_, frontier_.size(), grain,
                          [&](std::size_t begin, std::size_t end, std::size_t worker) {
                            DistanceBuckets& mine = buckets_[worker];
                            for (std::size_t i = begin; i < end; ++i) relax(frontier_[i], mine);
                            mine.relax_bucket(bucket, 2 * grain, [&](const NodeDistance& entry) {
                              relax(entry, mine);
                            });
                          });
      frontier_.clear();
      for (DistanceBuckets& b : buckets_) b.take(bucket, frontier_);
    }
  }
}

void NearestDistances::relax(const NodeDistance& entry, DistanceBuckets& mine) {
  if (relaxed_load(distance_[entry.node]) != entry.distance) return;
  for (ArcId a = graph_.first_arc[entry.node]; a < graph_.first_arc[entry.node + 1]; ++a) {
    const NodeId u = graph_.target[a];
    const std::uint32_t offered = entry.distance + graph_.length[a];
    if (!lower(u, offered)) continue;
    prefetch_arcs(graph_, u);
    mine.push({u, offered});
  }
}

// One thread alone needs no locked instruction.
bool NearestDistances::lower(NodeId node, std::uint32_t offered) {
  std::uint32_t& value = distance_[node];
  for (std::uint32_t before = relaxed_load(value); offered < before; before = relaxed_load(value)) {
    if (is_shared_) {
      if (!compare_exchange(value, before, offered)) continue;
    } else {
      value = offered;
    }
    std::uint8_t& is_stale = is_stale_[node / block_size];
    if (relaxed_load(is_stale) == 0) relaxed_store(is_stale, std::uint8_t{1});
    return true;
  }
  return false;
}

void NearestDistances::lower(std::span<const NodeDistance> entries) {
  for (const NodeDistance& entry : entries) lower(entry.node, entry.distance);
}

std::uint32_t NearestDistances::largest() {
  struct Largest {
    std::uint32_t value = 0;
    Largest& operator+=(const Largest& other) {
      value = std::max(value, other.value);
      return *this;
    }
  };
  return parallel_reduce<Largest>(executor_, block_.size(), block_grain,
                                  [&](std::size_t begin, std::size_t end) {
                                    Largest all;
                                    for (std::size_t i = begin; i < end; ++i) {
                                      const std::uint32_t block = block_[i];
                                      if (is_stale_[block] != 0) {
                                        is_stale_[block] = 0;
                                        const std::size_t first = block * block_size;
                                        const std::size_t last =
                                            std::min(first + block_size, distance_.size());
                                        std::uint32_t value = 0;
                                        for (std::size_t v = first; v < last; ++v)
                                          value = std::max(value, distance_[v]);
                                        largest_[block] = value;
                                      }
                                      all.value = std::max(all.value, largest_[block]);
                                    }
                                    return all;
                                  })
      .value;
}

std::vector<NodeId> NearestDistances::peaks_above(std::uint32_t distance) const {
  std::vector<std::vector<NodeId>> of_worker(executor_.threads());
  parallel_for_ranges(executor_, block_.size(), block_grain,
                      [&](std::size_t begin, std::size_t end, std::size_t worker) {
                        for (std::size_t i = begin; i < end; ++i) {
                          if (largest_[block_[i]] <= distance) continue;
                          const std::size_t first = block_[i] * block_size;
                          const std::size_t last = std::min(first + block_size, distance_.size());
                          for (std::size_t v = first; v < last; ++v) {
                            if (distance_[v] > distance && is_peak(static_cast<NodeId>(v))) {
                              of_worker[worker].push_back(static_cast<NodeId>(v));
                            }
                          }
                        }
                      });
  std::vector<NodeId> peaks;
  for (const std::vector<NodeId>& some : of_worker) {
    peaks.insert(peaks.end(), some.begin(), some.end());
  }
  std::sort(peaks.begin(), peaks.end());
  return peaks;
}

bool NearestDistances::is_peak(NodeId node) const {
  for (const NodeId u : graph_.neighbours(node)) {
    if (is_farther(u, node)) return false;
  }
  return true;
}

}  // namespace geolloyd
