#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/graph/graph.h"

namespace geolloyd {

/// A node and the distance it was lowered to: out of date once it has been lowered again.
struct NodeDistance {
  NodeId node;
  std::uint32_t distance;
};

/// Nodes whose arcs are still to be looked at, by distance. On a line of its own in the cache: each
/// thread has its own.
class alignas(64) DistanceBuckets {
 public:
  /// Buckets of 2^`width_bits` ticks.
  explicit DistanceBuckets(unsigned width_bits) : width_bits_(width_bits) {}

  // Inlined by force: where several files are joined, GCC thinks it has too many callers.
  [[gnu::always_inline]] void push(NodeDistance entry) {
    const std::size_t bucket = entry.distance >> width_bits_;
    if (at_.size() <= bucket) at_.resize(bucket + 1);
    at_[bucket].push_back(entry);
    end_ = std::max(end_, bucket + 1);
  }

  /// Of those in use.
  [[nodiscard]] std::size_t end() const { return end_; }
  /// The first bucket, from this one on, that is not empty; end() or more if there is none.
  [[nodiscard]] std::size_t first_from(std::size_t bucket) const {
    while (bucket < end_ && at_[bucket].empty()) ++bucket;
    return bucket;
  }
  /// Moves the entries of a bucket to the end of `entries`.
  void take(std::size_t bucket, std::vector<NodeDistance>& entries) {
    if (bucket >= end_) return;
    entries.insert(entries.end(), at_[bucket].begin(), at_[bucket].end());
    at_[bucket].clear();
  }
  void clear() {
    for (std::size_t b = 0; b < end_; ++b) at_[b].clear();
    end_ = 0;
  }

  /// Calls relax(entry) for all entries of a bucket, also those that come while it does, as long as
  /// there are no more than `most` of these at a time.
  template <class Relax>
  void relax_bucket(std::size_t bucket, std::size_t most, Relax&& relax) {
    while (bucket < end_ && !at_[bucket].empty() && at_[bucket].size() <= most) {
      again_.clear();
      again_.swap(at_[bucket]);
      for (const NodeDistance& entry : again_) relax(entry);
    }
  }

 private:
  unsigned width_bits_;
  std::vector<std::vector<NodeDistance>> at_;
  std::size_t end_ = 0;
  std::vector<NodeDistance> again_;  // being relaxed
};

}  // namespace geolloyd
