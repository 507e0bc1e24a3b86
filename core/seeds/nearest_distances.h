#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/executor.h"
#include "core/graph/graph.h"
#include "core/seeds/distance_buckets.h"

namespace geolloyd {

/// Distances, in ticks, to the nearest of sources that become more and more, in one component of a
/// graph after the other; and which nodes are far from all of them.
class NearestDistances {
 public:
  NearestDistances(const Graph& graph, Executor& executor);

  /// Goes on to another component, still without sources. `nodes` are all of it, ascending, and
  /// must live on.
  void enter(std::span<const NodeId> nodes);
  /// No node of it is far any more.
  void leave();

  /// The width of buckets of distance that suits the graph, as a power of two: about one mean arc.
  [[nodiscard]] unsigned width_bits() const { return width_bits_; }
  [[nodiscard]] const std::vector<std::uint32_t>& values() const { return distance_; }
  /// Whether node `a` is farther than `b`; of equals the smaller counts as farther.
  [[nodiscard]] bool is_farther(NodeId a, NodeId b) const {
    return distance_[a] != distance_[b] ? distance_[a] > distance_[b] : a < b;
  }

  /// Adds sources. Delta-stepping (Meyer, Sanders 2003) from all of them by all threads.
  void add(std::span<const NodeId> sources);
  /// Lowers distances, each as far as any says.
  void lower(std::span<const NodeDistance> entries);

  /// The largest distance.
  std::uint32_t largest();
  /// Nodes farther than `distance`, and than all their neighbours; ascending. Call largest() first.
  [[nodiscard]] std::vector<NodeId> peaks_above(std::uint32_t distance) const;

 private:
  static constexpr std::size_t block_size = 128;  // nodes

  bool lower(NodeId node, std::uint32_t offered);
  void relax(const NodeDistance& entry, DistanceBuckets& mine);
  [[nodiscard]] bool is_peak(NodeId node) const;

  const Graph& graph_;
  Executor& executor_;
  bool is_shared_;
  unsigned width_bits_;
  std::vector<std::uint32_t> distance_;  // per node; 0 outside of the component
  std::span<const NodeId> nodes_;
  std::vector<std::uint32_t> block_;      // those with nodes of the component, ascending
  std::vector<std::uint32_t> largest_;    // per block of the graph, unless it is stale
  std::vector<std::uint8_t> is_stale_;    // per block of the graph
  std::vector<DistanceBuckets> buckets_;  // per thread
  std::vector<NodeDistance> frontier_;
};

}  // namespace geolloyd
