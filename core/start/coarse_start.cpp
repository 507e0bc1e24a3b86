#include "core/start/coarse_start.h"

#include <algorithm>
#include <deque>
#include <utility>

#include "core/lloyd/engine.h"
#include "core/lloyd/relaxation.h"
#include "core/seeds/seeds.h"
#include "core/start/coarse_graph.h"

namespace geolloyd {
namespace {

constexpr std::size_t worth_while = 4;  // times as few nodes

// A graph, and for each node that of the next finer graph which it stands for.
struct CoarseLevel {
  Graph graph;
  std::vector<NodeId> place;
};

// Of the coarsest graph. Few seeds have room for many nodes each.
std::size_t nodes_for(std::size_t seeds, std::size_t given) {
  constexpr std::size_t few = 4096;
  constexpr std::size_t some = 16384;
  const std::size_t wanted = std::max(32 * seeds, std::clamp(128 * seeds, few, some));
  return std::min(wanted, given / worth_while);
}

// A round costs about as much as there are nodes.
std::uint32_t rounds_on(const Graph& graph) {
  constexpr std::size_t node_visits = 200'000;
  return static_cast<std::uint32_t>(
      std::clamp(node_visits / graph.node_count(), std::size_t{20}, std::size_t{60}));
}

CoarseLevel coarser(const Graph& graph, const Components& components, std::size_t nodes,
                    Runtime& runtime) {
  CoarseLevel level;
  level.place = spread_nodes(graph, components, nodes);
  const auto engine = runtime.make_engine(graph);
  level.graph = contract(graph, partition_of(*engine, level.place), nodes, runtime.executor());
  return level;
}

std::vector<NodeId> relaxed(const Graph& graph, std::vector<NodeId> seeds, std::uint32_t rounds,
                            Runtime& runtime) {
  RelaxationOptions options;
  options.greedy = GreedyMode::off;
  options.improvement_rounds = rounds;
  return relax(graph, *runtime.make_engine(graph), std::move(seeds), options).seeds;
}

}  // namespace

bool has_coarse_start(std::size_t nodes, std::size_t seeds) {
  constexpr std::size_t fewest_per_seed = 32;
  return worth_while * fewest_per_seed * seeds <= nodes;
}

std::vector<NodeId> seeds_on_coarse_graphs(const Graph& graph, const Components& components,
                                           std::size_t count, std::uint64_t random_seed,
                                           Runtime& runtime) {
  constexpr std::size_t coarser_by = 16;  // at most
  const std::size_t fewest = nodes_for(count, graph.node_count());
  std::deque<CoarseLevel> levels;  // from fine to coarse
  levels.push_back(
      coarser(graph, components, std::max(fewest, graph.node_count() / coarser_by), runtime));
  while (levels.back().graph.node_count() >= worth_while * fewest) {
    const Graph& finer = levels.back().graph;
    levels.push_back(coarser(finer, connected_components(finer),
                             std::max(fewest, finer.node_count() / coarser_by), runtime));
  }
  const Graph& coarsest = levels.back().graph;
  std::vector<NodeId> seeds = choose_seeds(coarsest, connected_components(coarsest),
                                           SeedInit::farthest, count, random_seed, runtime);
  for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
    const std::uint32_t rounds = level == levels.rbegin() ? rounds_on(coarsest) : 0;
    seeds = relaxed(level->graph, std::move(seeds), rounds, runtime);
    for (NodeId& seed : seeds) seed = level->place[seed];
  }
  return seeds;
}

}  // namespace geolloyd
