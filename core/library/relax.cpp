#include "geolloyd/relax.h"

#include <limits>
#include <string>
#include <utility>

#include "core/course/prepared_run.h"
#include "core/library/tessellated_graph.h"
#include "core/lloyd/engine.h"
#include "core/seeds/seed_file.h"
#include "core/seeds/seeds.h"
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

FindSeeds given_seeds(const RelaxOptions& options) {
  if (options.seed_count != 0) return {};
  if (!options.first_positions.empty()) {
    return [&options](const MeshGraph& mesh_graph, const Components& components) {
      return seeds_at(options.first_positions, "first_positions", mesh_graph, components);
    };
  }
  return [&options](const MeshGraph& mesh_graph, const Components& components) {
    GivenSeeds given{nodes_of_seeds(mesh_graph, options.first_seeds), {}};
    check_every_component_has_a_seed("first_seeds", mesh_graph, components, given.nodes);
    return given;
  };
}

MeshGraphOptions graph_options(const Mesh& mesh, const RelaxOptions& options) {
  return {options.graph, options.norm, checked_field(options.field, mesh.vertex_count()),
          options.averaging};
}

PreparedRun prepare(const Mesh& mesh, const RelaxOptions& options, Runtime& runtime) {
  validate(mesh, options);
  const RunPlan plan{graph_options(mesh, options),
                     {options.seed_count, options.init, options.random_seed, given_seeds(options)}};
  return prepare(mesh, find_edges(mesh, runtime.executor()), plan, runtime);
}

RelaxationOptions relaxation_options(const RelaxOptions& options) {
  RelaxationOptions relaxation;
  relaxation.max_greedy_steps = options.max_greedy_steps;
  relaxation.max_macrosteps = options.max_macrosteps;
  relaxation.improvement_rounds = options.improvement_rounds;
  relaxation.greedy = greedy_mode(options.greedy, options.seed_count == 0, options.init);
  return relaxation;
}

}  // namespace

Tessellation relax(const Mesh& mesh, const RelaxOptions& options, Runtime& runtime) {
  PreparedRun run = prepare(mesh, options, runtime);
  TessellatedGraph result{digest(mesh), std::move(run.mesh_graph), {}};
  const auto engine = runtime.make_engine(result.mesh_graph.graph);
  result.relaxation = relax(result.mesh_graph.graph, *engine, std::move(run.seeds),
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
  const PreparedRun run = prepare(mesh, options, runtime);
  std::vector<InputId> seeds;
  for (const NodeId node : run.seeds) seeds.push_back(run.mesh_graph.input_id[node]);
  return seeds;
}

std::vector<double> distances(const Mesh& mesh, const RelaxOptions& options, Runtime& runtime) {
  validate(mesh, options);
  if (options.first_seeds.empty()) throw InvalidInput("distances: from where? Give first_seeds");
  const MeshGraph made = make_mesh_graph(mesh, find_edges(mesh, runtime.executor()),
                                         graph_options(mesh, options), runtime.executor());
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
