#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/graph/graph.h"
#include "core/voronoi/energy.h"
#include "core/voronoi/partition.h"

namespace geolloyd {

/// Shortest distances from several sources at once, over one small graph: a node's distances, one
/// per source, lie in the lanes of one vector, so that relaxing an arc for all sources costs about
/// what it costs for one. Starts from upper bounds, which are nearly right where the sources are
/// neighbours of a node whose distances are known.
class SimdSearch {
 public:
  static constexpr std::size_t lanes = 8;
  using Vector [[gnu::vector_size(4 * lanes)]] = std::uint32_t;
  /// A vector as an element of containers, which lose the alignment of the bare one.
  struct alignas(Vector) Lanes {
    Vector d;
  };

  /// A node's bounds are its known distance plus, mod 2^32, the offset of its branch. They must not
  /// be below its distances.
  struct Bounds {
    std::span<const Key> known;                ///< per node
    std::span<const std::uint32_t> branch_of;  ///< per node, into `offset`; what is beyond is last
    std::span<const Lanes> offset;
  };

  /// Lowers the bounds to the distances from `sources`, at most one per lane. All these are below
  /// `most_distance` (partition.h). `order` holds all nodes, nearly by distance: the nearer, the
  /// faster.
  void run(const Graph& graph, std::span<const NodeId> sources, const Bounds& bounds,
           std::span<const NodeId> order);

  // Of the last run:
  [[nodiscard]] std::uint32_t distance(NodeId v, std::size_t lane) const { return at_[v].d[lane]; }
  /// Sum of distance^2 * mass over all nodes, exact.
  [[nodiscard]] std::array<Score, lanes> scores(const Graph& graph);

 private:
  std::vector<Lanes> at_;                // per node
  std::vector<NodeId> queue_;            // room for work
  std::vector<std::uint8_t> is_queued_;  // all 0 between runs
};

}  // namespace geolloyd
