#pragma once

#include <cstdint>
#include <vector>

#include "core/graph/graph.h"

namespace geolloyd {

/// Connected components, numbered in order of their smallest node.
struct Components {
  std::vector<std::uint32_t> component_of;  ///< per node
  std::vector<NodeId> first_in;             ///< per component, and one more: into `node`
  std::vector<NodeId> node;                 ///< all nodes by component, ascending within one

  [[nodiscard]] std::size_t size() const { return first_in.size() - 1; }
  [[nodiscard]] std::span<const NodeId> nodes(std::size_t component) const {
    return {node.data() + first_in[component], node.data() + first_in[component + 1]};
  }
};

Components connected_components(const Graph& graph);

}  // namespace geolloyd
