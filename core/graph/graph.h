#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "core/base/buffer.h"
#include "core/base/executor.h"
#include "core/base/types.h"

namespace geolloyd {

/// Most nodes a graph may have, for sums over them to fit (partition.h, subtree.h, energy.h).
inline constexpr std::size_t most_nodes = (std::size_t{1} << 30) - 1;
/// Most arcs, counting both directions: their positions are 32 bits wide, one value means "none".
inline constexpr std::size_t most_arcs = (std::size_t{1} << 32) - 2;
/// Most ticks an arc is long, and more than any two connected nodes are apart.
inline constexpr std::uint32_t most_length = std::uint32_t{1} << 30;
/// Most ticks of mass that a node has.
inline constexpr std::uint32_t most_mass = std::numeric_limits<std::uint32_t>::max();

/// An undirected graph as compressed rows, structure of arrays. Each arc is stored at both ends,
/// with the same length. After construction everything is an integer.
///
/// Lengths are in ticks of `tick_length` mesh units, in [1, most_length]; the tick is as fine as it
/// can be such that the shortest path between any two connected nodes stays below most_length
/// ticks. (Inside a locked region it may be up to twice as long: partition.h.) Masses are in ticks
/// of `tick_mass`, the largest being most_mass.
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

/// Fetches what is needed when the arcs of a node are looked at, for a search that will do so a
/// while after it has lowered the node.
inline void prefetch_arcs(const Graph& graph, NodeId node) {
  const ArcId first = graph.first_arc[node];
  __builtin_prefetch(graph.target.data() + first);
  __builtin_prefetch(graph.length.data() + first);
}

/// An arc before it is put in place at both ends. The length is in mesh units, a number, not
/// negative.
struct UndirectedArc {
  NodeId a;
  NodeId b;
  double length;
};

/// Throw InvalidInput where there are more than fit. They are called before memory is taken.
void check_node_count(std::size_t nodes);
void check_arc_count(std::uint64_t undirected_arcs);

/// Puts arcs in place and quantises lengths and masses. Of arcs between the same two nodes the
/// shortest stays; arcs from a node to itself go. Throws InvalidInput where there are more nodes or
/// arcs than fit, a path of more than most_path_arcs (ticks.h), or a length or mass so large that
/// twice the depth of a tree, or an energy, is not finite.
Graph make_graph(std::span<const UndirectedArc> arcs, std::span<const double> masses,
                 Executor& executor = sequential());

/// The same. The masses, one per node, are those that `masses` returns; it is called beside other
/// work. The arcs give their memory back before the graph's is taken.
Graph make_graph(Buffer<UndirectedArc> arcs, std::size_t nodes,
                 const std::function<std::vector<double>()>& masses, Executor& executor);

}  // namespace geolloyd
