#pragma once

#include <vector>

#include "core/base/random.h"
#include "core/graph/graph.h"

namespace geolloyd {

/// The n-th of a sequence of numbers in [0, bound).
inline std::uint32_t random_number(std::uint64_t random_seed, std::uint64_t n,
                                   std::uint64_t bound) {
  return static_cast<std::uint32_t>(random_below(random_seed, n, bound));
}

/// Small graphs that are hard on tie-breaking: few different lengths (0 among them), masses of 0,
/// several components, isolated nodes, repeated links.
inline Graph random_graph(std::uint64_t random_seed, NodeId node_count) {
  std::uint64_t n = 0;
  const auto draw = [&](std::uint64_t bound) { return random_number(random_seed, n++, bound); };
  const std::uint32_t link_count = draw(3 * node_count + 1);
  const std::uint32_t lengths = 1 + draw(5);
  std::vector<UndirectedArc> links;
  for (std::uint32_t i = 0; i < link_count; ++i) {
    links.push_back({draw(node_count), draw(node_count), static_cast<double>(draw(lengths + 1))});
  }
  std::vector<double> masses;
  for (NodeId v = 0; v < node_count; ++v) masses.push_back(draw(4));
  return make_graph(links, masses);
}

/// A connected one: a random tree, and links added to it.
inline Graph random_connected_graph(std::uint64_t random_seed, NodeId node_count) {
  std::uint64_t n = 0;
  const auto draw = [&](std::uint64_t bound) { return random_number(random_seed, n++, bound); };
  const std::uint32_t lengths = 1 + draw(40);
  std::vector<UndirectedArc> links;
  for (NodeId v = 1; v < node_count; ++v) {
    links.push_back({v, draw(v), static_cast<double>(draw(lengths + 1))});
  }
  for (std::uint32_t i = draw(2 * node_count); i > 0; --i) {
    links.push_back({draw(node_count), draw(node_count), static_cast<double>(draw(lengths + 1))});
  }
  std::vector<double> masses;
  for (NodeId v = 0; v < node_count; ++v) masses.push_back(1 + draw(4));
  return make_graph(links, masses);
}

/// `count` different nodes.
inline std::vector<NodeId> random_nodes(std::uint64_t random_seed, NodeId node_count,
                                        std::uint64_t count) {
  std::vector<NodeId> nodes(node_count);
  for (NodeId v = 0; v < node_count; ++v) nodes[v] = v;
  for (std::uint32_t i = 0; i < count; ++i) {
    std::swap(nodes[i], nodes[i + random_number(random_seed, i, node_count - i)]);
  }
  nodes.resize(count);
  return nodes;
}

/// A rows x columns grid of unit arcs and unit masses; node r * columns + c.
inline Graph grid_graph(NodeId rows, NodeId columns) {
  std::vector<UndirectedArc> links;
  for (NodeId r = 0; r < rows; ++r) {
    for (NodeId c = 0; c < columns; ++c) {
      const NodeId v = r * columns + c;
      if (c + 1 < columns) links.push_back({v, v + 1, 1.0});
      if (r + 1 < rows) links.push_back({v, v + columns, 1.0});
    }
  }
  return make_graph(links, std::vector<double>(std::size_t{rows} * columns, 1.0));
}

}  // namespace geolloyd
