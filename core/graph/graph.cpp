#include "core/graph/graph.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "core/base/errors.h"
#include "core/graph/graph_on.h"

namespace geolloyd {
namespace {

// An arc to a node reached for the first time, and how deep the node is; before its level is
// complete, how deep the node that it was reached from is.
struct Reached {
  LinkedArc arc;
  double depth;
};

// Depth of a breadth-first tree of each component, the largest of all. No shortest path is longer
// than twice that: it could go by the root. The tree is that of first discovery, row by row:
// another one would lead to another tick. Nothing here branches on whether a node is new: a guess
// would be wrong once per node.
Depth tree_depth(const TidyRows& rows, std::span<const Link> links) {
  constexpr std::size_t while_ahead = 12;
  std::vector<std::uint8_t> seen(rows.node_count(), 0);
  Buffer<Reached> reached(rows.node_count() + 1);
  std::size_t size = 0;
  Depth deepest;
  const auto reach = [&](NodeId v, double depth) {
    for (const LinkedArc arc : rows.row(v)) {
      reached[size] = {arc, depth};
      size += 1 - seen[target_of(arc)];
      seen[target_of(arc)] = 1;
    }
  };
  for (NodeId root = 0; root < rows.node_count(); ++root) {
    if (seen[root] != 0) continue;
    seen[root] = 1;
    size = 0;
    reach(root, 0);
    std::size_t level = 0;
    for (std::size_t arcs = 1; level < size; ++arcs) {
      deepest.arcs = std::max(deepest.arcs, arcs);
      const std::size_t end = size;
      for (std::size_t i = level; i < end; ++i) {
        reached[i].depth += link_of(reached[i].arc, links).length;
        deepest.length = std::max(deepest.length, reached[i].depth);
      }
      for (; level < end; ++level) {
        // Rows lie wherever their nodes do, but which come next is known a while before. (In a
        // function of their own the compiler would take prefetches for nothing.)
        if (level + 2 * while_ahead < end) {
          const NodeId later = target_of(reached[level + 2 * while_ahead].arc);
          __builtin_prefetch(rows.arcs.end.data() + later);
          __builtin_prefetch(rows.first_arc.data() + later);
          __builtin_prefetch(rows.row(target_of(reached[level + while_ahead].arc)).data());
        }
        reach(target_of(reached[level].arc), reached[level].depth);
      }
    }
  }
  return deepest;
}

}  // namespace

void check_node_count(std::size_t nodes) {
  if (nodes <= most_nodes) return;
  throw InvalidInput("the graph would have " + std::to_string(nodes) + " nodes, but at most " +
                     std::to_string(most_nodes) + " fit: use --graph vertex, or a coarser mesh");
}

void check_link_count(std::uint64_t links) {
  if (links <= most_arcs / 2) return;
  throw InvalidInput("the graph would have " + std::to_string(links) +
                     " arcs in each direction, but at most " + std::to_string(most_arcs / 2) +
                     " fit: use --graph vertex, or a coarser mesh");
}

std::uint32_t tidy_row(std::span<LinkedArc> row, std::span<const Link> links) {
  sort_entries(row);
  std::uint32_t kept = 0;
  for (const LinkedArc arc : row) {
    if (kept == 0 || target_of(row[kept - 1]) != target_of(arc)) {
      row[kept++] = arc;
    } else if (link_of(arc, links).length < link_of(row[kept - 1], links).length) {
      row[kept - 1] = arc;
    }
  }
  return kept;
}

// The ticks put aside for rounding are lost in 2^30.
double tick_length_for(const Depth& depth) {
  if (depth.arcs > most_path_arcs) {
    throw InvalidInput("a path of the graph has " + std::to_string(depth.arcs) +
                       " arcs, too many for exact distances: use a coarser mesh");
  }
  const double longest = 2 * depth.length;
  if (!std::isfinite(longest)) {
    throw InvalidInput("a path of the graph is too long for a number: scale the mesh down");
  }
  if (longest == 0) return 1;
  const auto ticks = static_cast<double>(most_length - 2 * depth.arcs - rounding_ticks);
  return std::max(longest / ticks, std::numeric_limits<double>::min());
}

double choose_tick_length(const TidyRows& rows, std::span<const Link> links) {
  return tick_length_for(tree_depth(rows, links));
}

double choose_tick_mass(std::span<const double> masses) {
  const double largest = masses.empty() ? 0 : *std::max_element(masses.begin(), masses.end());
  if (!std::isfinite(largest)) {
    throw InvalidInput("the area of a node is too large for a number: scale the mesh down");
  }
  if (largest == 0) return 1;
  return std::max(largest / most_mass, std::numeric_limits<double>::min());
}

std::uint32_t to_mass_ticks(double mass, double tick) {
  return static_cast<std::uint32_t>(std::min<double>(std::round(mass / tick), most_mass));
}

void check_energies(const Graph& graph) {
  const double farthest = most_length * graph.tick_length;
  const auto mass = std::accumulate(graph.mass.begin(), graph.mass.end(), std::uint64_t{0});
  if (std::isfinite(farthest * farthest * graph.tick_mass * static_cast<double>(mass))) return;
  throw InvalidInput(
      "distances and areas are so large that energies would be infinite: scale the mesh, or the "
      "magnitudes of its field, down");
}

Graph make_graph(std::span<const Link> links, std::span<const double> masses) {
  Sequential one;
  return make_graph_on(one, links, masses.size(), [&] { return masses; });
}

}  // namespace geolloyd
