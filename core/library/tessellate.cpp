#include "geolloyd/tessellate.h"

#include <string>
#include <utility>

#include "core/graph/components.h"
#include "core/library/tessellated_graph.h"
#include "core/start/first_seeds.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

void validate(const Mesh& mesh, const TessellateOptions& options) {
  validate(mesh);
  if (options.seed_count == 0 && options.first_seeds.empty()) {
    throw InvalidInput("seeds: give seed_count, or first_seeds");
  }
  if (options.seed_count != 0 && !options.first_seeds.empty()) {
    throw InvalidInput("seeds: give seed_count or first_seeds, not both");
  }
}

// A graph and the first seeds on it. What sites of the surface take is given back before the graph
// is made.
std::vector<NodeId> make_graph_and_seeds(const Mesh& mesh, std::span<const TangentSpace> field,
                                         const TessellateOptions& options, Runtime& runtime,
                                         MeshGraph& mesh_graph) {
  MeshEdges edges = find_edges(mesh, runtime.executor());
  keep_for_arcs(edges, options.graph);
  const FirstSeedOptions first{options.init, options.seed_count, options.random_seed, field};
  std::vector<SeedPlace> places;
  if (options.first_seeds.empty()) {
    places =
        find_first_places(mesh, edges.duplicates,
                          count_nodes(mesh, options.graph, runtime.executor()), first, runtime);
  }
  mesh_graph = make_mesh_graph(
      mesh, std::move(edges),
      {options.graph, options.norm, {field.begin(), field.end()}, options.averaging},
      runtime.executor());
  const Components components = connected_components(mesh_graph.graph);
  return options.first_seeds.empty()
             ? choose_first_seeds(mesh, places, mesh_graph, components, first, runtime)
             : nodes_of_seeds(mesh_graph, components, options.first_seeds);
}

RelaxationOptions relaxation_options(const TessellateOptions& options) {
  RelaxationOptions relaxation;
  relaxation.max_greedy_steps = options.max_greedy_steps;
  relaxation.max_macrosteps = options.max_macrosteps;
  relaxation.improvement_rounds = options.improvement_rounds;
  const bool is_given = !options.first_seeds.empty();
  relaxation.greedy = options.greedy.value_or(is_given ? GreedyMode::extended
                                                       : suggested_greedy_mode(options.init));
  return relaxation;
}

}  // namespace

Tessellation tessellate(const Mesh& mesh, const TessellateOptions& options, Runtime& runtime) {
  validate(mesh, options);
  const std::vector<TangentSpace> field = checked_field(options.field, mesh.vertex_count());
  TessellatedGraph result;
  result.mesh_digest = digest(mesh);
  std::vector<NodeId> seeds =
      make_graph_and_seeds(mesh, field, options, runtime, result.mesh_graph);
  const auto engine = runtime.make_engine(result.mesh_graph.graph);
  result.relaxation = relax(result.mesh_graph.graph, *engine, std::move(seeds),
                            relaxation_options(options), options.progress);
  return describe(std::move(result));
}

Tessellation voronoi(const Mesh& mesh, TessellateOptions options, Runtime& runtime) {
  options.max_greedy_steps = 0;
  options.max_macrosteps = 0;
  options.improvement_rounds = 0;
  return tessellate(mesh, options, runtime);
}

}  // namespace geolloyd
