#include "tools/run/stages.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/formats/tangent_field_file.h"
#include "core/graph/components.h"
#include "core/graph/graph.h"
#include "core/graph/mesh_graph.h"
#include "core/mesh/cross_field.h"
#include "core/mesh/curvature_field.h"
#include "core/mesh/properties.h"
#include "core/seeds/seed_file.h"
#include "core/start/first_seeds.h"
#include "core/text/file_io.h"
#include "parallel/library/scheduler_runtime.h"
#include "tools/render/picture.h"
#include "tools/run/measured_run.h"
#include "tools/system/memory_estimate.h"
#include "tools/system/memory_limit.h"

namespace geolloyd {
namespace {

// Of all there is to come, once the edges are known.
std::uint64_t estimate_memory(const GraphArguments& arguments, const LoadedInput& loaded,
                              std::size_t seeds, const Purpose& purpose, Scheduler& scheduler) {
  const Mesh& mesh = loaded.input.mesh();
  const GraphKind kind = arguments.kind;
  RunSize size;
  size.vertices = mesh.vertex_count();
  size.triangles = mesh.triangle_count();
  size.edges = loaded.edges.size();
  size.nodes =
      (has_vertices(kind) ? size.vertices : 0) + (has_triangles(kind) ? size.triangles : 0);
  size.has_triangle_nodes = has_triangles(kind);
  size.links = count_arcs(mesh, loaded.edges, kind, scheduler);
  check_arc_count(size.links);
  size.seeds = std::clamp<std::uint64_t>(seeds, 1, size.nodes);
  size.threads = scheduler.threads();
  size.has_field = !arguments.vfield.empty();
  size.has_curvature_field = arguments.has_curvature_field();
  size.has_cross_field = arguments.has_cross_field();
  size.is_reference = purpose.engine == EngineKind::reference;
  size.has_ground_truth = purpose.has_ground_truth;
  size.property_bytes = bytes_of(loaded.input.loaded.properties);
  const SeedInit init =
      purpose.init == SeedInit::automatic ? suited_init(size.nodes, size.seeds) : purpose.init;
  size.has_coarse_graph = init == SeedInit::coarse;
  // Some ten vertices for each site, where the mesh has fewer (start/surface_start.h).
  if (init == SeedInit::surface) {
    size.fine_vertices = size.vertices + (size.has_field ? 24 : 10) * size.seeds;
  }
  if (purpose.picture) {
    size.samples = count_samples(mesh, purpose.picture->view, purpose.picture->size, scheduler);
  }
  return memory_to_run(size);
}

// `text` is that of the seeds file, if there is one.
std::vector<NodeId> first_seeds(const SeedArguments& arguments, const std::string& text,
                                const Start& start, std::span<const TangentSpace> field,
                                std::span<const TriangleId> duplicates,
                                const Components& components, Scheduler& scheduler) {
  if (!arguments.file.empty()) {
    return parse_seeds(text, arguments.file.string(), start.mesh_graph, components);
  }
  SchedulerRuntime runtime(scheduler);
  return choose_first_seeds(start.input.mesh(), duplicates, start.mesh_graph, components,
                            {arguments.init, arguments.count, arguments.random_seed, field},
                            runtime);
}

}  // namespace

Scheduler make_scheduler(const ThreadArguments& threads) {
  make_room_for_threads(threads.count);
  return Scheduler(threads.count, threads.backend);
}

std::vector<TangentSpace> find_field(const FieldArguments& arguments, const Mesh& mesh,
                                     const MeshEdges& edges, Executor& executor) {
  if (arguments.vfield.empty()) return {};
  if (arguments.has_curvature_field()) return curvature_field(mesh, edges, executor);
  if (arguments.has_cross_field()) return cross_field(mesh, edges, executor);
  return read_tangent_field(arguments.vfield, mesh.vertex_count());
}

BuiltGraph build_graph(const GraphArguments& arguments, const LoadedInput& loaded,
                       std::size_t seeds, const Purpose& purpose, Scheduler& scheduler) {
  BuiltGraph built;
  built.memory_estimate = estimate_memory(arguments, loaded, seeds, purpose, scheduler);
  announce_memory(loaded.input.file.string(), built.memory_estimate);
  const Stopwatch watch;
  const Mesh& mesh = loaded.input.mesh();
  MeshGraphOptions options{arguments.kind, arguments.norm,
                           find_field(arguments, mesh, loaded.edges, scheduler),
                           arguments.averaging};
  built.mesh_graph = make_mesh_graph(mesh, loaded.edges, options, scheduler);
  built.field = std::move(options.vertex_space);
  built.seconds = watch.seconds();
  return built;
}

Start prepare(const StartArguments& arguments, Purpose purpose, Scheduler& scheduler,
              ProgressLine& progress) {
  if (arguments.seeds.file.empty()) purpose.init = arguments.seeds.init;
  Start start;
  std::string seeds_text;
  std::vector<TriangleId> duplicates;
  std::vector<TangentSpace> field;
  progress.stage("reading " + arguments.mesh.string());
  {
    LoadedInput loaded =
        load_input(arguments.mesh, scheduler, {arguments.has_properties}, arguments.repair);
    const SeedArguments& seeds = arguments.seeds;
    if (!seeds.file.empty()) seeds_text = read_file(seeds.file);
    progress.stage("building the " + name_of(graph_kind_names, arguments.graph.kind) + " graph");
    BuiltGraph built =
        build_graph(arguments.graph, loaded,
                    seeds.file.empty() ? seeds.count : most_seeds(seeds_text), purpose, scheduler);
    start.input = std::move(loaded.input);
    start.mesh_graph = std::move(built.mesh_graph);
    field = std::move(built.field);
    duplicates = std::move(loaded.edges.duplicates);
    start.memory_estimate = built.memory_estimate;
    start.seconds.load = loaded.seconds;
    start.seconds.graph = loaded.edge_seconds + built.seconds;
  }
  progress.stage("choosing seeds");
  const Stopwatch watch;
  const Components components = connected_components(start.mesh_graph.graph);
  start.components = components.size();
  start.seeds =
      first_seeds(arguments.seeds, seeds_text, start, field, duplicates, components, scheduler);
  start.seconds.seeds = watch.seconds();
  return start;
}

EnginePartition partition_seeds(const Graph& graph, std::span<const NodeId> seeds,
                                Frontier frontier, Scheduler& scheduler) {
  auto engine = make_engine(EngineKind::parallel, frontier, scheduler, graph);
  engine->partition(seeds);
  Partition partition = engine->current();
  return {std::move(engine), std::move(partition)};
}

}  // namespace geolloyd
