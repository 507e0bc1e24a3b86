#include "core/course/prepared_run.h"

#include <string>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/mesh/mesh_topology.h"
#include "core/regions/regions_of_nodes.h"
#include "core/start/first_seeds.h"

namespace geolloyd {
namespace {

FirstSeedOptions seed_options(const SeedPlan& plan, std::span<const TangentSpace> field) {
  return {plan.init, plan.count, plan.random_seed, field};
}

// Of the surface, before the graph is made, whose memory is not taken yet. Meanwhile the edges give
// theirs back, too: to find them again takes a twentieth of the time.
std::vector<SeedPlace> find_places(const Mesh& mesh, MeshEdges& edges, const RunPlan& plan,
                                   Runtime& runtime) {
  const FirstSeedOptions options = seed_options(plan.seeds, plan.graph.vertex_space);
  const std::size_t nodes = count_nodes(mesh, plan.graph.kind, runtime.executor());
  if (plan.seeds.given || !has_first_places(nodes, options)) return {};
  release_all_but_duplicates(edges);
  std::vector<SeedPlace> places =
      find_first_places(mesh, edges.duplicates, nodes, options, runtime);
  edges = find_edges(mesh, runtime.executor());
  return places;
}

GivenSeeds find_seeds(const Mesh& mesh, std::span<const SeedPlace> places,
                      std::span<const TangentSpace> field, const MeshGraph& mesh_graph,
                      const Components& components, const SeedPlan& plan, Runtime& runtime) {
  if (plan.given) return plan.given(mesh_graph, components);
  const FirstSeedOptions options = seed_options(plan, field);
  return {choose_first_seeds(mesh, places, mesh_graph, components, options, runtime), {}};
}

void begin(const CourseHooks& hooks, const char* stage) {
  if (hooks.stage) hooks.stage(stage);
}

}  // namespace

// Most of the edges go before the places of seeds are found, and these before there is a graph.
PreparedRun prepare(const Mesh& mesh, MeshEdges edges, const RunPlan& plan, Runtime& runtime,
                    const CourseHooks& hooks) {
  PreparedRun run;
  begin(hooks, "building the graph");
  const Stopwatch building;
  if (plan.has_dual && !has_triangles(plan.graph.kind)) {
    run.surface = find_surface(mesh, edges, runtime.executor());
  }
  const Stopwatch placing;
  const std::vector<SeedPlace> places = find_places(mesh, edges, plan, runtime);
  run.seconds.seeds = placing.seconds();
  keep_for_arcs(edges, plan.graph.kind);
  run.mesh_graph = make_mesh_graph(mesh, std::move(edges), plan.graph, runtime.executor());
  run.seconds.graph = building.seconds() - run.seconds.seeds;

  begin(hooks, "choosing seeds");
  const Stopwatch choosing;
  const Components components = connected_components(run.mesh_graph.graph);
  run.components = components.size();
  GivenSeeds found = find_seeds(mesh, places, plan.graph.vertex_space, run.mesh_graph, components,
                                plan.seeds, runtime);
  run.seeds = std::move(found.nodes);
  run.seed_fit = found.fit;
  run.seconds.seeds += choosing.seconds();
  return run;
}

InputSurface find_surface(const Mesh& mesh, const MeshEdges& edges, Executor& executor) {
  return {find_topology(mesh, edges, executor), irregular_edges(edges)};
}

GivenSeeds find_first_seeds(const Mesh& mesh, const MeshEdges& edges,
                            std::span<const TangentSpace> field, const MeshGraph& mesh_graph,
                            const Components& components, const SeedPlan& plan, Runtime& runtime) {
  std::vector<SeedPlace> places;
  if (!plan.given) {
    places = find_first_places(mesh, edges.duplicates, mesh_graph.graph.node_count(),
                               seed_options(plan, field), runtime);
  }
  return find_seeds(mesh, places, field, mesh_graph, components, plan, runtime);
}

GraphDual make_dual(const Mesh& mesh, const PreparedRun& run, const std::vector<NodeId>& seeds,
                    const Partition& partition, Engine& engine, const GraphDualOptions& options,
                    Executor& executor) {
  const bool suffices = run.surface && !has_triangles(run.mesh_graph.kind);
  return make_graph_dual({mesh, run.mesh_graph, seeds, partition, engine, executor,
                          suffices ? &*run.surface : nullptr},
                         options);
}

}  // namespace geolloyd
