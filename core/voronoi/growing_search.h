#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/graph/graph.h"
#include "core/voronoi/partition.h"

namespace geolloyd {

/// The partition, regions free, of a set of seeds that grows one by one.
class GrowingSearch {
 public:
  GrowingSearch() = default;
  GrowingSearch(const GrowingSearch&) = delete;
  GrowingSearch& operator=(const GrowingSearch&) = delete;
  virtual ~GrowingSearch() = default;

  /// Adds a seed and returns the nodes that are nearer to it than to those before, in no particular
  /// order; some may be listed more than once. Valid until the next call.
  virtual std::span<const NodeId> add(NodeId seed) = 0;

  /// Per node; the region is the number of the seed.
  [[nodiscard]] virtual const std::vector<Key>& keys() const = 0;
};

/// By Dijkstra's algorithm from each new seed.
std::unique_ptr<GrowingSearch> make_growing_search(const Graph& graph);

}  // namespace geolloyd
