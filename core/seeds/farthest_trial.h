#pragma once

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "core/graph/graph.h"
#include "core/seeds/distance_buckets.h"
#include "core/seeds/nearest_distances.h"

namespace geolloyd {

/// A number per node, 0 at first. Takes memory only where it is written.
class SparseNumbers {
 public:
  explicit SparseNumbers(std::size_t size);
  std::uint32_t& operator[](std::size_t i) { return values_.get()[i]; }

 private:
  struct Free {
    void operator()(std::uint32_t* values) const { std::free(values); }
  };
  std::unique_ptr<std::uint32_t, Free> values_;
};

/// Finds what a node would lower if it became a source, and lowers nothing. One thread at a time
/// may use a trial; many threads may have one each.
class FarthestTrial {
 public:
  FarthestTrial(const Graph& graph, const NearestDistances& nearest);

  /// False where a way by nodes that all are farther than `above` leads to one farther than `node`.
  bool is_farthest_around(NodeId node, std::uint32_t above);

  /// False where the node would lower a farther one. Otherwise adds what it lowers to `lowered`.
  bool search(NodeId node, std::vector<NodeDistance>& lowered);

 private:
  bool relax(const NodeDistance& entry, NodeId from, std::vector<NodeDistance>& lowered);

  const Graph& graph_;
  const NearestDistances& nearest_;
  SparseNumbers closeness_;  // per node: inverted bits of its distance, or 0
  DistanceBuckets buckets_;
  std::vector<NodeId> reached_;
};

}  // namespace geolloyd
