#include "core/start/first_seeds.h"

#include <algorithm>

#include "core/lloyd/relaxation.h"
#include "core/mesh/mesh_measure.h"
#include "core/seeds/seed_places.h"
#include "core/seeds/seeds.h"
#include "core/start/coarse_graph.h"
#include "core/start/surface_start.h"
#include "core/surface/site_places.h"

namespace geolloyd {
namespace {

// Fewer sites than a closed surface has at least, or none at all where there is no area.
std::vector<NodeId> seeds_on_surface(const Mesh& mesh, std::span<const TriangleId> duplicates,
                                     const MeshGraph& mesh_graph, std::size_t count,
                                     Runtime& runtime) {
  constexpr std::size_t fewest_sites = 4;
  double area = 0;
  for (const double a : triangle_areas(mesh, duplicates, runtime.executor())) area += a;
  if (count < fewest_sites || !(area > 0)) return {};
  const SurfaceStart start = make_surface_start(
      mesh, duplicates, area, count,
      [&](const FineMesh& fine) { return runtime.make_surface_engine(fine); }, runtime.executor());
  const LabelledSites& state = start.resting.state;
  std::vector<SeedPlace> places;
  for (const SurfacePoint& point :
       place_sites(mesh, start.input(), state.sites.positions, state.labels, runtime.executor())) {
    if (point.triangle == no_id) continue;
    places.push_back({point.triangle, position_of(mesh, point)});
  }
  return seeds_near(mesh, mesh_graph, places);
}

// Where seeds rest, after some rounds of improvement, on a graph with some nodes for each: rounds
// cost little there. None where the graph is not much finer.
std::vector<NodeId> seeds_on_coarse_graph(const Graph& graph, const Components& components,
                                          std::size_t count, std::uint64_t random_seed,
                                          Runtime& runtime) {
  constexpr std::size_t nodes_per_seed = 32;
  constexpr std::size_t fewest_nodes = 4096;
  const std::size_t nodes = std::max(nodes_per_seed * count, fewest_nodes);
  if (4 * nodes > graph.node_count()) return {};
  std::vector<NodeId> places = choose_seeds(graph, components, SeedInit::random_area, nodes,
                                            random_seed, *runtime.make_growing_search(graph));
  std::sort(places.begin(), places.end());
  const Graph coarse =
      contract(graph, partition_of(*runtime.make_engine(graph), places), nodes, runtime.executor());
  const std::vector<NodeId> first =
      choose_seeds(coarse, connected_components(coarse), SeedInit::farthest, count, random_seed,
                   *runtime.make_growing_search(coarse));
  RelaxationOptions options;
  options.greedy = GreedyMode::off;
  options.improvement_rounds = 20;
  std::vector<NodeId> seeds = relax(coarse, *runtime.make_engine(coarse), first, options).seeds;
  for (NodeId& seed : seeds) seed = places[seed];
  return seeds;
}

}  // namespace

std::vector<NodeId> choose_first_seeds(const Mesh& mesh, std::span<const TriangleId> duplicates,
                                       const MeshGraph& mesh_graph, const Components& components,
                                       const FirstSeedOptions& options, Runtime& runtime) {
  const Graph& graph = mesh_graph.graph;
  const auto [init, count, random_seed] = options;
  check_seed_count(graph, components, count);
  if (init == SeedInit::surface || init == SeedInit::coarse) {
    const std::vector<NodeId> found =
        init == SeedInit::surface
            ? seeds_on_surface(mesh, duplicates, mesh_graph, count, runtime)
            : seeds_on_coarse_graph(graph, components, count, random_seed, runtime);
    return complete_seeds(graph, components, found, count, random_seed,
                          *runtime.make_growing_search(graph));
  }
  return choose_seeds(graph, components, init, count, random_seed,
                      *runtime.make_growing_search(graph));
}

}  // namespace geolloyd
