#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "core/base/grouping.h"
#include "core/graph/graph.h"

namespace geolloyd {

/// The arcs of a graph to be: target in the high half, so that a row sorts by it, and the id of the
/// link whose length it has in the low one.
using LinkedArc = std::uint64_t;

inline NodeId target_of(LinkedArc arc) {
  return static_cast<NodeId>(arc >> 32);
}
inline const Link& link_of(LinkedArc arc, std::span<const Link> links) {
  return links[static_cast<std::uint32_t>(arc)];
}

// Before memory is taken for them. Throw InvalidInput.
void check_node_count(std::size_t nodes);
void check_link_count(std::uint64_t links);

/// Both directions of each link; loops go.
template <class Executor>
Groups<LinkedArc> group_by_source(Executor& executor, std::span<const Link> links,
                                  std::size_t nodes) {
  return group_items<LinkedArc>(executor, nodes, links.size(), [&](std::size_t i, auto&& put) {
    const Link& link = links[i];
    if (link.a == link.b) return;
    put(link.a, (LinkedArc{link.b} << 32) | i);
    put(link.b, (LinkedArc{link.a} << 32) | i);
  });
}

/// Sorts a row by target and keeps the shortest arc to each. Returns how many are left, in front.
std::uint32_t tidy_row(std::span<LinkedArc> row, std::span<const Link> links);

/// Arcs by row, each row tidy in front.
struct TidyRows {
  Groups<LinkedArc> arcs;
  std::vector<ArcId> first_arc;  ///< per node, and one more, once they stand close

  [[nodiscard]] std::size_t node_count() const { return arcs.size(); }
  [[nodiscard]] std::span<const LinkedArc> row(NodeId node) const {
    return arcs[node].first(first_arc[node + 1] - first_arc[node]);
  }
};

template <class Executor>
TidyRows tidy_rows(Executor& executor, std::span<const Link> links, std::size_t nodes) {
  TidyRows rows{group_by_source(executor, links, nodes), {}};
  rows.first_arc.assign(nodes + 1, 0);
  for_items(executor, nodes, small_items,
            [&](std::size_t v) { rows.first_arc[v] = tidy_row(rows.arcs[v], links); });
  exclusive_scan<ArcId>(executor, rows.first_arc);
  return rows;
}

/// How deep breadth-first trees are: the largest of all components.
struct Depth {
  double length = 0;  ///< mesh units
  std::size_t arcs = 0;
};

/// Rounding adds a tick at most to every arc, and two ways to the root bound a path: with so many
/// arcs that may be half of all ticks there are.
inline constexpr std::size_t rounding_ticks = 64;  ///< what the sum of a path's lengths is off by
inline constexpr std::size_t most_path_arcs = (most_length / 2 - rounding_ticks) / 2;

/// As fine as Graph says. Throws InvalidInput where a path has too many arcs.
double tick_length_for(const Depth& depth);
double choose_tick_length(const TidyRows& rows, std::span<const Link> links);
double choose_tick_mass(std::span<const double> masses);

/// Throws InvalidInput where a sum of mass * distance^2 could be infinite.
void check_energies(const Graph& graph);

/// An arc longer than every shortest path is on none, so its length may be cut to fit. The double
/// just below one half, which alone would not round to nearest this way, is less than a tick.
inline std::uint32_t to_length_ticks(double length, double tick) {
  return static_cast<std::uint32_t>(std::clamp<double>(length / tick + 0.5, 1, most_length));
}
std::uint32_t to_mass_ticks(double mass, double tick);

/// See graph.h. The masses are those that masses() returns. Like the choice of a tick that may be
/// one thread's work, and taking memory is, so all are done at once.
template <class Executor, class Masses>
Graph make_graph_on(Executor& executor, std::span<const Link> links, std::size_t nodes,
                    Masses&& masses) {
  check_node_count(nodes);
  check_link_count(links.size());
  TidyRows rows = tidy_rows(executor, links, nodes);
  Graph graph;
  decltype(masses()) mass;
  run_each(
      executor, [&] { graph.tick_length = choose_tick_length(rows, links); },
      [&] {
        mass = masses();
        graph.tick_mass = choose_tick_mass(mass);
        graph.mass.resize(nodes);
      },
      [&] { graph.target.resize(rows.first_arc.back()); },
      [&] { graph.length.resize(rows.first_arc.back()); });
  for_items(executor, nodes, small_items, [&](std::size_t v) {
    ArcId place = rows.first_arc[v];
    for (const LinkedArc arc : rows.row(static_cast<NodeId>(v))) {
      graph.target[place] = target_of(arc);
      graph.length[place++] = to_length_ticks(link_of(arc, links).length, graph.tick_length);
    }
    graph.mass[v] = to_mass_ticks(mass[v], graph.tick_mass);
  });
  graph.first_arc = std::move(rows.first_arc);
  check_energies(graph);
  return graph;
}

}  // namespace geolloyd
