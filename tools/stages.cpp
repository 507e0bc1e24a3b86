#include "tools/stages.h"

#include "core/components.h"
#include "core/seed_file.h"
#include "core/seeds.h"
#include "core/stopwatch.h"
#include "core/tangent_field_file.h"
#include "parallel/growing_search.h"
#include "parallel/mesh_check.h"
#include "parallel/mesh_edges.h"
#include "parallel/mesh_graph.h"
#include "tools/measured_run.h"
#include "tools/names.h"

namespace geolloyd {

// Edges are arcs to be, so finding them counts as building the graph.
MeshEdges load_mesh(RunRecord& run, Scheduler& scheduler) {
  const Stopwatch watch;
  run.input = read_mesh(run.arguments.mesh);
  const Stopwatch finding;
  MeshEdges edges = find_edges(scheduler, run.input.mesh);
  run.seconds.graph = finding.seconds();
  run.facts = check_mesh(scheduler, run.input.mesh, edges);
  run.seconds.load = watch.seconds() - run.seconds.graph;
  return edges;
}

void build_graph(RunRecord& run, Scheduler& scheduler, const MeshEdges& edges) {
  const Stopwatch watch;
  const RelaxArguments& a = run.arguments;
  MeshGraphOptions options{value_of(graph_kind_names, a.graph), value_of(norm_names, a.norm), {}};
  if (!a.vfield.empty()) {
    options.vertex_space = read_tangent_field(a.vfield, run.input.mesh.vertex_count());
  }
  run.mesh_graph = make_mesh_graph(scheduler, run.input.mesh, edges, options);
  run.seconds.graph += watch.seconds();
}

namespace {

std::vector<NodeId> first_seeds(RunRecord& run, Scheduler& scheduler) {
  const Stopwatch watch;
  const RelaxArguments& a = run.arguments;
  const Graph& graph = run.mesh_graph.graph;
  const Components components = connected_components(graph);
  run.components = components.size();
  std::vector<NodeId> seeds =
      a.seeds_file.empty()
          ? choose_seeds(graph, components, value_of(seed_init_names, a.init), a.seeds,
                         a.random_seed, *make_growing_search(scheduler, graph))
          : read_seed_file(a.seeds_file, run.mesh_graph, components);
  run.seconds.seeds = watch.seconds();
  return seeds;
}

}  // namespace

Scheduler make_scheduler(const RelaxArguments& a) {
  return Scheduler(a.threads, value_of(backend_names, a.backend));
}

std::vector<NodeId> prepare(RunRecord& run, Scheduler& scheduler, ProgressLine& progress) {
  progress.stage("reading " + run.arguments.mesh.string());
  {
    const MeshEdges edges = load_mesh(run, scheduler);
    progress.stage("building the " + run.arguments.graph + " graph");
    build_graph(run, scheduler, edges);
  }
  progress.stage("choosing seeds");
  return first_seeds(run, scheduler);
}

void find_ground_truth(RunRecord& run, Scheduler& scheduler, ProgressLine& progress) {
  progress.stage("finding the ground truth");
  const Stopwatch watch;
  run.ground_truth = make_ground_truth(scheduler, run.input.mesh, run.mesh_graph,
                                       run.relaxation.partition, run.relaxation.seeds);
  run.seconds.ground_truth = watch.seconds();
}

std::unique_ptr<Engine> partition_seeds(RunRecord& run, Scheduler& scheduler) {
  auto engine = make_engine(EngineKind::parallel, value_of(frontier_names, run.arguments.frontier),
                            scheduler, run.mesh_graph.graph);
  engine->partition(run.relaxation.seeds);
  run.relaxation.partition = engine->current();
  return engine;
}

}  // namespace geolloyd
