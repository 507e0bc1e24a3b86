#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/graph/mesh_graph.h"

namespace geolloyd {

/// What became of positions that stand for nodes.
struct PositionFit {
  std::size_t left_out = 0;  ///< positions whose nearest node is that of an earlier one
  double farthest = 0;       ///< mesh units: the largest distance of a position to its node
};

struct NearestNodes {
  std::vector<NodeId> nodes;  ///< different, in the order of the positions
  PositionFit fit;
};

/// For each position, which is finite, the node nearest to it in space; of several the one with the
/// smallest input id. The graph has a node.
NearestNodes nearest_nodes(const MeshGraph& mesh_graph, std::span<const Vec3> positions);

}  // namespace geolloyd
