#include "core/graph/graph.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "core/base/loops.h"
#include "core/graph/sorted_rows.h"
#include "core/graph/ticks.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

void check_energies(const Graph& graph) {
  const double farthest = most_length * graph.tick_length;
  const auto mass = std::accumulate(graph.mass.begin(), graph.mass.end(), std::uint64_t{0});
  if (std::isfinite(farthest * farthest * graph.tick_mass * static_cast<double>(mass))) return;
  throw InvalidInput(
      "distances and areas are so large that energies would be infinite: scale the mesh, or the "
      "magnitudes of its field, down");
}

// Ticks take the place of the numbers of arcs.
void quantise_lengths(SortedRows& rows, std::span<const UndirectedArc> arcs, double tick,
                      Executor& executor) {
  parallel_for(executor, rows.node_count(), small_items, [&](std::size_t v) {
    for (PlacedArc& arc : rows.row(static_cast<NodeId>(v))) {
      arc = (PlacedArc{target_of(arc)} << 32) | to_length_ticks(length_of(arc, arcs), tick);
    }
  });
}

std::vector<std::uint32_t> quantised_masses(const std::vector<double>& masses, double tick,
                                            Executor& executor) {
  std::vector<std::uint32_t> ticks(masses.size());
  parallel_for(executor, masses.size(), small_items,
               [&](std::size_t v) { ticks[v] = to_mass_ticks(masses[v], tick); });
  return ticks;
}

}  // namespace

void check_node_count(std::size_t nodes) {
  if (nodes <= most_nodes) return;
  throw InvalidInput("the graph would have " + std::to_string(nodes) + " nodes, but at most " +
                     std::to_string(most_nodes) + " fit: use --graph vertex, or a coarser mesh");
}

void check_arc_count(std::uint64_t links) {
  if (links <= most_arcs / 2) return;
  throw InvalidInput("the graph would have " + std::to_string(links) +
                     " arcs in each direction, but at most " + std::to_string(most_arcs / 2) +
                     " fit: use --graph vertex, or a coarser mesh");
}

Graph make_graph(std::span<const UndirectedArc> arcs, std::span<const double> masses,
                 Executor& executor) {
  Buffer<UndirectedArc> copy(arcs.size());
  std::copy(arcs.begin(), arcs.end(), copy.begin());
  return make_graph(
      std::move(copy), masses.size(),
      [&] { return std::vector<double>(masses.begin(), masses.end()); }, executor);
}

// The choice of the tick is one thread's work, and the masses are another's: both are done at once.
Graph make_graph(Buffer<UndirectedArc> arcs, std::size_t nodes,
                 const std::function<std::vector<double>()>& masses, Executor& executor) {
  check_node_count(nodes);
  check_arc_count(arcs.size());
  const std::span<const UndirectedArc> all_arcs(arcs.begin(), arcs.end());
  SortedRows rows = sort_rows(all_arcs, nodes, executor);
  Graph graph;
  std::vector<double> mass;
  parallel_invoke(
      executor, [&] { graph.tick_length = tick_length_for(tree_depth(rows, all_arcs)); },
      [&] {
        mass = masses();
        graph.tick_mass = choose_tick_mass(mass);
      });
  quantise_lengths(rows, all_arcs, graph.tick_length, executor);
  arcs = {};
  graph.mass = quantised_masses(std::exchange(mass, {}), graph.tick_mass, executor);
  parallel_invoke(
      executor, [&] { graph.target = huge_vector<NodeId>(rows.first_arc.back()); },
      [&] { graph.length = huge_vector<std::uint32_t>(rows.first_arc.back()); });
  parallel_for(executor, nodes, small_items, [&](std::size_t v) {
    ArcId place = rows.first_arc[v];
    for (const PlacedArc arc : rows.row(static_cast<NodeId>(v))) {
      graph.target[place] = target_of(arc);
      graph.length[place++] = static_cast<std::uint32_t>(arc);
    }
  });
  graph.first_arc = std::move(rows.first_arc);
  check_energies(graph);
  return graph;
}

}  // namespace geolloyd
