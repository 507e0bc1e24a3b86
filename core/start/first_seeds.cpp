#include "core/start/first_seeds.h"

#include "core/mesh/mesh_measure.h"
#include "core/seeds/seed_places.h"
#include "core/seeds/seeds.h"
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

}  // namespace

std::vector<NodeId> choose_first_seeds(const Mesh& mesh, std::span<const TriangleId> duplicates,
                                       const MeshGraph& mesh_graph, const Components& components,
                                       const FirstSeedOptions& options, Runtime& runtime) {
  const Graph& graph = mesh_graph.graph;
  const auto [init, count, random_seed] = options;
  check_seed_count(graph, components, count);
  if (init == SeedInit::surface) {
    const std::vector<NodeId> near_sites =
        seeds_on_surface(mesh, duplicates, mesh_graph, count, runtime);
    return complete_seeds(graph, components, near_sites, count, random_seed,
                          *runtime.make_growing_search(graph));
  }
  return choose_seeds(graph, components, init, count, random_seed,
                      *runtime.make_growing_search(graph));
}

}  // namespace geolloyd
