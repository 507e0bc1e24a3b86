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

std::vector<NodeId> find_first_seeds(const Mesh& mesh, const MeshEdges& edges,
                                     const MeshGraph& mesh_graph,
                                     std::span<const TangentSpace> field,
                                     const TessellateOptions& options, Runtime& runtime) {
  const Components components = connected_components(mesh_graph.graph);
  if (!options.first_seeds.empty()) {
    return nodes_of_seeds(mesh_graph, components, options.first_seeds);
  }
  return choose_first_seeds(mesh, edges.duplicates, mesh_graph, components,
                            {options.init, options.seed_count, options.random_seed, field},
                            runtime);
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
  const MeshEdges edges = find_edges(mesh, runtime.executor());
  result.mesh_graph = make_mesh_graph(
      mesh, edges, {options.graph, options.norm, field, options.averaging}, runtime.executor());
  const auto engine = runtime.make_engine(result.mesh_graph.graph);
  result.relaxation =
      relax(result.mesh_graph.graph, *engine,
            find_first_seeds(mesh, edges, result.mesh_graph, field, options, runtime),
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
