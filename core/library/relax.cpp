#include "geolloyd/relax.h"

#include <limits>
#include <string>
#include <utility>

#include "core/graph/components.h"
#include "core/library/tessellated_graph.h"
#include "core/lloyd/engine.h"
#include "core/seeds/seed_file.h"
#include "core/seeds/seeds.h"
#include "core/start/first_seeds.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

void validate(const Mesh& mesh, const RelaxOptions& options) {
  validate(mesh);
  const int given = (options.seed_count != 0 ? 1 : 0) + (options.first_seeds.empty() ? 0 : 1) +
                    (options.first_positions.empty() ? 0 : 1);
  if (given == 0) throw InvalidInput("seeds: give seed_count, first_seeds or first_positions");
  if (given > 1) {
    throw InvalidInput("seeds: give one of seed_count, first_seeds and first_positions");
  }
  for (const Vec3& position : options.first_positions) {
    if (!is_usable(position.x()) || !is_usable(position.y()) || !is_usable(position.z())) {
      throw InvalidInput("first_positions: a coordinate is not a finite number of usable size");
    }
  }
}

// A graph and the first seeds on it. What sites of the surface take is given back before the graph
// is made.
std::vector<NodeId> make_graph_and_seeds(const Mesh& mesh, std::span<const TangentSpace> field,
                                         const RelaxOptions& options, Runtime& runtime,
                                         MeshGraph& mesh_graph) {
  MeshEdges edges = find_edges(mesh, runtime.executor());
  keep_for_arcs(edges, options.graph);
  const FirstSeedOptions first{options.init, options.seed_count, options.random_seed, field};
  std::vector<SeedPlace> places;
  if (options.seed_count != 0) {
    places =
        find_first_places(mesh, edges.duplicates,
                          count_nodes(mesh, options.graph, runtime.executor()), first, runtime);
  }
  mesh_graph = make_mesh_graph(
      mesh, std::move(edges),
      {options.graph, options.norm, {field.begin(), field.end()}, options.averaging},
      runtime.executor());
  const Components components = connected_components(mesh_graph.graph);
  if (options.seed_count != 0) {
    return choose_first_seeds(mesh, places, mesh_graph, components, first, runtime);
  }
  if (!options.first_positions.empty()) {
    return seeds_at(options.first_positions, "first_positions", mesh_graph, components).nodes;
  }
  std::vector<NodeId> nodes = nodes_of_seeds(mesh_graph, options.first_seeds);
  check_every_component_has_a_seed("first_seeds", mesh_graph, components, nodes);
  return nodes;
}

RelaxationOptions relaxation_options(const RelaxOptions& options) {
  RelaxationOptions relaxation;
  relaxation.max_greedy_steps = options.max_greedy_steps;
  relaxation.max_macrosteps = options.max_macrosteps;
  relaxation.improvement_rounds = options.improvement_rounds;
  const bool is_given = options.seed_count == 0;
  relaxation.greedy = options.greedy.value_or(is_given ? GreedyMode::extended
                                                       : suggested_greedy_mode(options.init));
  return relaxation;
}

}  // namespace

Tessellation relax(const Mesh& mesh, const RelaxOptions& options, Runtime& runtime) {
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

Tessellation voronoi(const Mesh& mesh, RelaxOptions options, Runtime& runtime) {
  options.max_greedy_steps = 0;
  options.max_macrosteps = 0;
  options.improvement_rounds = 0;
  return relax(mesh, options, runtime);
}

std::vector<InputId> first_seeds(const Mesh& mesh, const RelaxOptions& options, Runtime& runtime) {
  validate(mesh, options);
  const std::vector<TangentSpace> field = checked_field(options.field, mesh.vertex_count());
  MeshGraph mesh_graph;
  std::vector<InputId> seeds;
  for (const NodeId node : make_graph_and_seeds(mesh, field, options, runtime, mesh_graph)) {
    seeds.push_back(mesh_graph.input_id[node]);
  }
  return seeds;
}

std::vector<double> distances(const Mesh& mesh, const RelaxOptions& options, Runtime& runtime) {
  validate(mesh, options);
  if (options.first_seeds.empty()) throw InvalidInput("distances: from where? Give first_seeds");
  const MeshGraph made =
      make_mesh_graph(mesh, find_edges(mesh, runtime.executor()),
                      {options.graph, options.norm,
                       checked_field(options.field, mesh.vertex_count()), options.averaging},
                      runtime.executor());
  const auto engine = runtime.make_engine(made.graph);
  const Partition& partition = partition_of(*engine, nodes_of_seeds(made, options.first_seeds));
  std::vector<double> result(made.node_of.size(), std::numeric_limits<double>::infinity());
  for (NodeId v = 0; v < made.graph.node_count(); ++v) {
    const Key key = partition.key[v];
    if (key != unreached) result[made.input_id[v]] = distance_of(key) * made.graph.tick_length;
  }
  return result;
}

}  // namespace geolloyd
