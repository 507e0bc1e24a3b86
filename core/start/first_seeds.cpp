#include "core/start/first_seeds.h"

#include <algorithm>

#include "core/base/disjoint_sets.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_measure.h"
#include "core/seeds/seed_places.h"
#include "core/seeds/seeds.h"
#include "core/start/coarse_start.h"
#include "core/start/surface_start.h"
#include "core/surface/result/site_places.h"

namespace geolloyd {
namespace {

// From where seeds go on with a graph, sites need not have come to rest.
constexpr RestEffort start_effort = {600'000, 12, 50, false};

SeedInit init_of(const FirstSeedOptions& options, std::size_t nodes) {
  return options.init == SeedInit::automatic ? suited_init(nodes, options.count) : options.init;
}

// Parts of a mesh: triangles that share vertices are in one.
std::size_t count_parts(const Mesh& mesh, Executor& executor) {
  DisjointSets sets(mesh.vertex_count(), executor);
  const auto joined = parallel_reduce<std::size_t>(
      executor, mesh.triangle_count(), small_items, [&](std::size_t begin, std::size_t end) {
        std::size_t unions = 0;
        for (std::size_t t = begin; t < end; ++t) {
          const auto& [a, b, c] = mesh.triangles[t];
          unions += (sets.unite(a, b) ? 1U : 0U) + (sets.unite(b, c) ? 1U : 0U);
        }
        return unions;
      });
  const std::vector<std::uint8_t> is_used = referenced_vertices(mesh, executor);
  return static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), 1)) - joined;
}

}  // namespace

SeedInit suited_init(std::size_t nodes, std::size_t count) {
  constexpr std::size_t few_seeds = 128;
  constexpr std::size_t fewest_nodes_per_seed = 6;
  if (count <= few_seeds && has_coarse_start(nodes, count)) return SeedInit::coarse;
  return count <= nodes / fewest_nodes_per_seed ? SeedInit::surface : SeedInit::farthest;
}

bool has_first_places(std::size_t nodes, const FirstSeedOptions& options) {
  return init_of(options, nodes) == SeedInit::surface && options.count <= nodes;
}

// None for fewer sites than a closed surface has at least, where there is no area, or a field that
// sites cannot follow. None either where parts get one seed each: each part has some sites at
// least, and where the only seed begins decides little.
std::vector<SeedPlace> find_first_places(const Mesh& mesh, std::span<const TriangleId> duplicates,
                                         std::size_t nodes, const FirstSeedOptions& options,
                                         Runtime& runtime) {
  constexpr std::size_t fewest_sites = 4;
  constexpr std::size_t fewest_per_part = 2;
  if (!has_first_places(nodes, options)) return {};
  double area = 0;
  for (const double a : triangle_areas(mesh, duplicates, runtime.executor())) area += a;
  if (options.count < fewest_sites || !(area > 0) || !can_spread(options.field)) return {};
  if (options.count < fewest_per_part * count_parts(mesh, runtime.executor())) return {};
  const SurfaceStart start = make_surface_start(mesh, duplicates, area, options.count,
                                                options.field, start_effort, runtime);
  const LabelledSites& state = start.resting.state;
  std::vector<SeedPlace> places;
  for (const SurfacePoint& point :
       place_sites(mesh, start.input(), state.sites.positions, state.labels, runtime.executor())) {
    if (point.triangle == no_id) continue;
    places.push_back({point.triangle, position_of(mesh, point)});
  }
  return places;
}

std::vector<NodeId> choose_first_seeds(const Mesh& mesh, std::span<const SeedPlace> places,
                                       const MeshGraph& mesh_graph, const Components& components,
                                       const FirstSeedOptions& options, Runtime& runtime) {
  const Graph& graph = mesh_graph.graph;
  const std::size_t count = options.count;
  const std::uint64_t random_seed = options.random_seed;
  check_seed_count(graph, components, count);
  const SeedInit init = init_of(options, graph.node_count());
  if (init == SeedInit::surface) {
    const std::vector<NodeId> near = seeds_near(mesh, mesh_graph, places);
    return complete_seeds(graph, components, near, count, random_seed, runtime);
  }
  if (init == SeedInit::coarse && has_coarse_start(graph.node_count(), count)) {
    return complete_seeds(graph, components,
                          seeds_on_coarse_graphs(graph, components, count, random_seed, runtime),
                          count, random_seed, runtime);
  }
  return choose_seeds(graph, components, init, count, random_seed, runtime);
}

}  // namespace geolloyd
