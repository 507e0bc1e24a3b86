#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/types.h"

namespace geolloyd {

/// An undirected graph as compressed rows, structure of arrays. Each arc is stored at both ends,
/// with the same length. After construction everything is an integer.
///
/// Lengths are in ticks of `tick_length` mesh units, in [1, 2^30]; the tick is as fine as it can be
/// such that the shortest path between any two connected nodes stays below 2^30 ticks. (Inside a
/// locked region paths may have to go by way of the seed it was found from, which takes up to twice
/// that; one more arc, and a distance still fits into 32 bits.) Masses are in ticks of `tick_mass`,
/// the largest being 2^32 - 1.
struct Graph {
  std::vector<ArcId> first_arc{0};    ///< per node, and one more
  std::vector<NodeId> target;         ///< per arc; ascending within a node, no repeats, no loops
  std::vector<std::uint32_t> length;  ///< per arc, ticks
  std::vector<std::uint32_t> mass;    ///< per node, ticks
  double tick_length = 1;             ///< mesh units
  double tick_mass = 1;               ///< square mesh units

  [[nodiscard]] std::size_t node_count() const { return mass.size(); }
  [[nodiscard]] std::size_t arc_count() const { return target.size(); }
  [[nodiscard]] std::span<const NodeId> neighbours(NodeId node) const {
    return {target.data() + first_arc[node], target.data() + first_arc[node + 1]};
  }
};

/// One undirected arc before it is put in place; length in mesh units, not negative.
struct Link {
  NodeId a;
  NodeId b;
  double length;
};

/// Puts links in place and quantises lengths and masses. Of links between the same two nodes the
/// shortest stays; links from a node to itself go. Throws InvalidInput where 32-bit ids, or ticks
/// for a path of very many arcs, do not suffice, and where an energy could be beyond all doubles.
Graph make_graph(std::span<const Link> links, std::span<const double> masses);

/// Most nodes a graph may have, for sums over nodes to fit (energy.h).
inline constexpr std::size_t most_nodes = (std::size_t{1} << 30) - 1;
/// Most arcs, counting both directions.
inline constexpr std::size_t most_arcs = (std::size_t{1} << 32) - 2;

}  // namespace geolloyd
