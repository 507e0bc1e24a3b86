#include "core/graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/errors.h"

namespace geolloyd {
namespace {

struct Arc {
  NodeId target;
  double length;
};

struct Rows {
  std::vector<ArcId> first;
  std::vector<Arc> arc;
};

void check_limits(std::size_t nodes, std::size_t arcs) {
  if (nodes > most_nodes || arcs > most_arcs) {
    throw InvalidInput("the graph would have " + std::to_string(nodes) + " nodes and " +
                       std::to_string(arcs) + " arcs; at most " + std::to_string(most_nodes) +
                       " and " + std::to_string(most_arcs) +
                       " fit: use a coarser mesh or a graph kind with fewer arcs");
  }
}

Rows sort_by_source(std::span<const Link> links, std::size_t node_count) {
  Rows rows;
  rows.first.assign(node_count + 1, 0);
  for (const Link& link : links) {
    ++rows.first[link.a + 1];
    ++rows.first[link.b + 1];
  }
  for (std::size_t v = 0; v < node_count; ++v) rows.first[v + 1] += rows.first[v];

  rows.arc.resize(rows.first.back());
  std::vector<ArcId> next(rows.first.begin(), rows.first.end() - 1);
  for (const Link& link : links) {
    rows.arc[next[link.a]++] = {link.b, link.length};
    rows.arc[next[link.b]++] = {link.a, link.length};
  }
  return rows;
}

// Sorts each row by target and keeps the shortest of equals; loops go.
void tidy(Rows& rows) {
  ArcId kept = 0;
  ArcId begin = 0;
  for (std::size_t v = 0; v + 1 < rows.first.size(); ++v) {
    const ArcId end = rows.first[v + 1];
    std::sort(rows.arc.begin() + begin, rows.arc.begin() + end, [](const Arc& x, const Arc& y) {
      return x.target != y.target ? x.target < y.target : x.length < y.length;
    });
    const ArcId row = kept;
    for (ArcId i = begin; i < end; ++i) {
      const bool repeated = kept > row && rows.arc[kept - 1].target == rows.arc[i].target;
      if (!repeated && rows.arc[i].target != v) rows.arc[kept++] = rows.arc[i];
    }
    begin = end;
    rows.first[v + 1] = kept;
  }
  rows.arc.resize(kept);
}

struct Depth {
  double length = 0;
  std::size_t arcs = 0;
};

// Depth of a breadth-first tree of each component, the largest of all. No shortest path is longer
// than twice that: it could go by the root.
Depth tree_depth(const Rows& rows) {
  constexpr double unseen = -1;
  std::vector<double> depth(rows.first.size() - 1, unseen);
  std::vector<NodeId> level;
  std::vector<NodeId> next_level;
  Depth deepest;
  for (NodeId root = 0; root < depth.size(); ++root) {
    if (depth[root] != unseen) continue;
    depth[root] = 0;
    level.assign(1, root);
    for (std::size_t arcs = 0; !level.empty(); ++arcs) {
      next_level.clear();
      for (const NodeId v : level) {
        deepest.length = std::max(deepest.length, depth[v]);
        for (ArcId i = rows.first[v]; i < rows.first[v + 1]; ++i) {
          double& target_depth = depth[rows.arc[i].target];
          if (target_depth != unseen) continue;
          target_depth = depth[v] + rows.arc[i].length;
          next_level.push_back(rows.arc[i].target);
        }
      }
      deepest.arcs = std::max(deepest.arcs, arcs);
      level.swap(next_level);
    }
  }
  return deepest;
}

constexpr double most_length_ticks = 0x1p30;

// Rounding may add a tick to every arc of the path, and the depth itself was summed with rounding:
// the ticks put aside for both are lost in 2^30.
double choose_tick_length(const Rows& rows) {
  const Depth depth = tree_depth(rows);
  if (depth.length == 0) return 1;
  const double budget = most_length_ticks - 2 * static_cast<double>(depth.arcs) - 64;
  if (budget < most_length_ticks / 2) {
    throw InvalidInput("a path of the graph has " + std::to_string(depth.arcs) +
                       " arcs, too many for exact distances: use a coarser mesh");
  }
  return std::max(2 * depth.length / budget, std::numeric_limits<double>::min());
}

// An arc longer than every shortest path is on none, so its length may be cut to fit.
std::uint32_t to_length_ticks(double length, double tick) {
  return static_cast<std::uint32_t>(std::clamp(std::round(length / tick), 1.0, most_length_ticks));
}

void quantise_masses(std::span<const double> masses, Graph& graph) {
  const double largest = masses.empty() ? 0 : *std::max_element(masses.begin(), masses.end());
  constexpr double most_ticks = 0x1p32 - 1;
  if (largest > 0) {
    graph.tick_mass = std::max(largest / most_ticks, std::numeric_limits<double>::min());
  }
  graph.mass.reserve(masses.size());
  for (const double m : masses) {
    graph.mass.push_back(
        static_cast<std::uint32_t>(std::min(std::round(m / graph.tick_mass), most_ticks)));
  }
}

}  // namespace

Graph make_graph(std::span<const Link> links, std::span<const double> masses) {
  check_limits(masses.size(), 2 * links.size());
  Rows rows = sort_by_source(links, masses.size());
  tidy(rows);

  Graph graph;
  graph.tick_length = choose_tick_length(rows);
  graph.target.reserve(rows.arc.size());
  graph.length.reserve(rows.arc.size());
  for (const Arc& arc : rows.arc) {
    graph.target.push_back(arc.target);
    graph.length.push_back(to_length_ticks(arc.length, graph.tick_length));
  }
  graph.first_arc = std::move(rows.first);
  quantise_masses(masses, graph);
  return graph;
}

}  // namespace geolloyd
