#include "core/start/first_seeds.h"

#include <algorithm>

#include "core/mesh/mesh_measure.h"
#include "core/seeds/seed_places.h"
#include "core/seeds/seeds.h"
#include "core/start/coarse_start.h"
#include "core/start/surface_start.h"
#include "core/surface/site_places.h"

namespace geolloyd {
namespace {

// From where seeds go on with a graph, sites need not have come to rest.
constexpr RestEffort start_effort = {600'000, 12, 50, false};

// Fewer sites than a closed surface has at least, or none at all where there is no area, or a field
// that sites cannot follow.
std::vector<NodeId> seeds_on_surface(const Mesh& mesh, std::span<const TriangleId> duplicates,
                                     const MeshGraph& mesh_graph, const FirstSeedOptions& options,
                                     Runtime& runtime) {
  constexpr std::size_t fewest_sites = 4;
  double area = 0;
  for (const double a : triangle_areas(mesh, duplicates, runtime.executor())) area += a;
  if (options.count < fewest_sites || !(area > 0) || !can_spread(options.field)) return {};
  const SurfaceStart start = make_surface_start(
      mesh, duplicates, area, options.count, options.field, start_effort,
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

}  // namespace

SeedInit suited_init(std::size_t nodes, std::size_t count) {
  constexpr std::size_t few_seeds = 128;
  constexpr std::size_t fewest_nodes_per_seed = 6;
  if (count <= few_seeds && has_coarse_start(nodes, count)) return SeedInit::coarse;
  return count <= nodes / fewest_nodes_per_seed ? SeedInit::surface : SeedInit::farthest;
}

std::vector<NodeId> choose_first_seeds(const Mesh& mesh, std::span<const TriangleId> duplicates,
                                       const MeshGraph& mesh_graph, const Components& components,
                                       const FirstSeedOptions& options, Runtime& runtime) {
  const Graph& graph = mesh_graph.graph;
  const auto [asked, count, random_seed, field] = options;
  check_seed_count(graph, components, count);
  const SeedInit init =
      asked == SeedInit::automatic ? suited_init(graph.node_count(), count) : asked;
  if (init == SeedInit::surface) {
    return complete_seeds(graph, components,
                          seeds_on_surface(mesh, duplicates, mesh_graph, options, runtime), count,
                          random_seed, runtime);
  }
  if (init == SeedInit::coarse && has_coarse_start(graph.node_count(), count)) {
    return complete_seeds(graph, components,
                          seeds_on_coarse_graphs(graph, components, count, random_seed, runtime),
                          count, random_seed, runtime);
  }
  return choose_seeds(graph, components, init, count, random_seed, runtime);
}

}  // namespace geolloyd
