#include "tools/run/stages.h"

#include <algorithm>
#include <system_error>

#include "core/base/stopwatch.h"
#include "core/formats/tangent_field_file.h"
#include "core/graph/components.h"
#include "core/graph/graph.h"
#include "core/graph/mesh_graph.h"
#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_edges.h"
#include "core/seeds/seed_file.h"
#include "core/seeds/seeds.h"
#include "core/text/file_io.h"
#include "parallel/engine/parallel_growing_search.h"
#include "tools/render/picture.h"
#include "tools/run/measured_run.h"
#include "tools/system/memory_estimate.h"
#include "tools/system/memory_limit.h"
#include "tools/words/names.h"

namespace geolloyd {

LoadedMesh read_within_limits(const std::filesystem::path& path) {
  std::error_code unknown;  // is for the reader to tell
  const auto file_size = std::filesystem::file_size(path, unknown);
  if (!unknown) require_memory(path.string(), memory_to_read(file_size));
  LoadedMesh loaded = read_mesh(path);
  require_memory(path.string(),
                 memory_to_check(loaded.mesh.vertex_count(), loaded.mesh.triangle_count()));
  return loaded;
}

namespace {

// Of all there is to come, once the edges are known.
std::uint64_t estimate_memory(const RunRecord& run, const MeshEdges& edges, std::size_t seeds,
                              Scheduler& scheduler) {
  const RelaxArguments& a = run.arguments;
  const Mesh& mesh = run.input.mesh;
  const GraphKind kind = value_of(graph_kind_names, a.graph);
  RunSize size;
  size.vertices = mesh.vertex_count();
  size.triangles = mesh.triangle_count();
  size.edges = edges.size();
  size.nodes =
      (has_vertices(kind) ? size.vertices : 0) + (has_triangles(kind) ? size.triangles : 0);
  size.has_triangle_nodes = has_triangles(kind);
  size.links = count_arcs(mesh, edges, kind);
  check_arc_count(size.links);
  size.seeds = std::clamp<std::uint64_t>(seeds, 1, size.nodes);
  size.threads = scheduler.threads();
  size.has_field = !a.vfield.empty();
  size.is_reference = value_of(engine_names, a.engine) == EngineKind::reference;
  size.has_ground_truth = a.ground_truth || a.remesh_vertices == "centroids";
  if (!a.picture.empty() || !a.frames.empty()) {
    size.samples = count_samples(mesh, parse_view(a.view), parse_size(a.size), scheduler);
  }
  return memory_to_run(size);
}

}  // namespace

// Edges are arcs to be, so finding them counts as building the graph.
MeshEdges load_mesh(RunRecord& run, Scheduler& scheduler) {
  const Stopwatch watch;
  run.input = read_within_limits(run.arguments.mesh);
  const Stopwatch finding;
  MeshEdges edges = find_edges(run.input.mesh, scheduler);
  run.seconds.graph = finding.seconds();
  run.facts = check_mesh(run.input.mesh, edges, scheduler);
  run.seconds.load = watch.seconds() - run.seconds.graph;
  return edges;
}

void build_graph(RunRecord& run, Scheduler& scheduler, const MeshEdges& edges, std::size_t seeds) {
  run.memory_estimate = estimate_memory(run, edges, seeds, scheduler);
  announce_memory(run.arguments.mesh.string(), run.memory_estimate);
  const Stopwatch watch;
  const RelaxArguments& a = run.arguments;
  MeshGraphOptions options{value_of(graph_kind_names, a.graph), value_of(norm_names, a.norm), {}};
  if (!a.vfield.empty()) {
    options.vertex_space = read_tangent_field(a.vfield, run.input.mesh.vertex_count());
  }
  run.mesh_graph = make_mesh_graph(run.input.mesh, edges, options, scheduler);
  run.seconds.graph += watch.seconds();
}

namespace {

// `text` is that of the seeds file, if there is one.
std::vector<NodeId> first_seeds(RunRecord& run, const std::string& text, Scheduler& scheduler) {
  const Stopwatch watch;
  const RelaxArguments& a = run.arguments;
  const Graph& graph = run.mesh_graph.graph;
  const Components components = connected_components(graph);
  run.components = components.size();
  std::vector<NodeId> seeds =
      a.seeds_file.empty()
          ? choose_seeds(graph, components, value_of(seed_init_names, a.init), a.seeds,
                         a.random_seed, *make_parallel_growing_search(scheduler, graph))
          : parse_seeds(text, a.seeds_file.string(), run.mesh_graph, components);
  run.seconds.seeds = watch.seconds();
  return seeds;
}

}  // namespace

Scheduler make_scheduler(const RelaxArguments& a) {
  make_room_for_threads(a.threads);
  return Scheduler(a.threads, value_of(backend_names, a.backend));
}

RemeshOptions remesh_options(const RelaxArguments& a) {
  return {a.manifold, value_of(remesh_vertices_names, a.remesh_vertices)};
}

std::vector<NodeId> prepare(RunRecord& run, Scheduler& scheduler, ProgressLine& progress) {
  const RelaxArguments& a = run.arguments;
  progress.stage("reading " + a.mesh.string());
  std::string seeds_text;
  {
    const MeshEdges edges = load_mesh(run, scheduler);
    if (!a.seeds_file.empty()) seeds_text = read_file(a.seeds_file);
    progress.stage("building the " + a.graph + " graph");
    build_graph(run, scheduler, edges, a.seeds_file.empty() ? a.seeds : most_seeds(seeds_text));
  }
  progress.stage("choosing seeds");
  return first_seeds(run, seeds_text, scheduler);
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
