#include "tools/run/stages.h"

#include <string>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/formats/tangent_field_file.h"
#include "core/graph/components.h"
#include "core/graph/graph.h"
#include "core/graph/mesh_graph.h"
#include "core/mesh/cross_field.h"
#include "core/mesh/curvature_field.h"
#include "core/mesh/mesh_topology.h"
#include "core/regions/regions_of_nodes.h"
#include "core/seeds/seed_places.h"
#include "core/start/first_seeds.h"
#include "parallel/library/scheduler_runtime.h"
#include "tools/render/picture.h"
#include "tools/run/measured_run.h"
#include "tools/run/memory_need.h"
#include "tools/run/seed_source.h"
#include "tools/system/memory_limit.h"

namespace geolloyd {
namespace {

MeshGraphOptions graph_options(const GraphArguments& arguments, const LoadedInput& loaded,
                               Executor& executor) {
  return {arguments.kind, arguments.norm,
          find_field(arguments, loaded.input.mesh(), loaded.edges, executor), arguments.averaging};
}

std::uint64_t memory_to_relax(const GraphArguments& graph, const LoadedInput& loaded,
                              std::size_t seeds, const Purpose& purpose, Scheduler& scheduler) {
  const Mesh& mesh = loaded.input.mesh();
  WorkSize size = size_of(loaded.input.loaded);
  size.sites = seeds;
  size.has_field = !graph.vfield.empty();
  size.has_cross_field = graph.has_cross_field();
  size.has_ground_truth = purpose.has_ground_truth;
  if (purpose.picture) {
    size.samples = count_samples(mesh, purpose.picture->view, purpose.picture->size, scheduler);
  }
  return memory_to_relax(mesh, loaded.edges, graph.kind, size, scheduler);
}

// Before the graph is made, whose memory is not taken yet. Meanwhile the edges give theirs back,
// too: to find them again takes a twentieth of the time.
std::vector<SeedPlace> find_first_places(const SeedArguments& arguments,
                                         const MeshGraphOptions& graph, MeshEdges& edges,
                                         Start& start, Scheduler& scheduler) {
  const Mesh& mesh = start.input.mesh();
  const std::size_t nodes = count_nodes(mesh, graph.kind, scheduler);
  const FirstSeedOptions options{arguments.init, arguments.count, arguments.random_seed,
                                 graph.vertex_space};
  if (!arguments.file.empty() || !has_first_places(nodes, options)) return {};
  const Stopwatch watch;
  edges = {{}, {}, {}, std::move(edges.duplicates)};
  SchedulerRuntime runtime(scheduler);
  std::vector<SeedPlace> places =
      find_first_places(mesh, edges.duplicates, nodes, options, runtime);
  start.seconds.seeds = watch.seconds();
  edges = find_edges(mesh, scheduler);
  return places;
}

// `source` is there where a file gives them.
GivenSeeds first_seeds(const SeedArguments& arguments, const std::optional<SeedSource>& source,
                       const Start& start, std::span<const SeedPlace> places,
                       std::span<const TangentSpace> field, const Components& components,
                       Scheduler& scheduler) {
  if (source) return source->find(start.mesh_graph, components);
  SchedulerRuntime runtime(scheduler);
  return {
      choose_first_seeds(start.input.mesh(), places, start.mesh_graph, components,
                         {arguments.init, arguments.count, arguments.random_seed, field}, runtime),
      {}};
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
                       std::size_t seeds, Scheduler& scheduler) {
  const std::uint64_t estimate = memory_to_relax(arguments, loaded, seeds, {}, scheduler);
  announce_memory(loaded.input.file.string(), estimate);
  return {make_mesh_graph(loaded.input.mesh(), loaded.edges,
                          graph_options(arguments, loaded, scheduler), scheduler),
          estimate};
}

// What takes memory gives it back as soon as nothing needs it: most of the edges before the places
// of seeds are found, and these before there is a graph.
Start prepare(const StartArguments& arguments, const Purpose& purpose, Scheduler& scheduler,
              ProgressLine& progress) {
  const SeedArguments& seeds = arguments.seeds;
  const GraphKind kind = arguments.graph.kind;
  Start start;
  progress.stage("reading " + arguments.mesh.string());
  LoadedInput loaded =
      load_input(arguments.mesh, scheduler, {arguments.has_properties}, arguments.repair);
  std::optional<SeedSource> source;
  if (!seeds.file.empty()) source.emplace(seeds);
  start.memory_estimate = memory_to_relax(
      arguments.graph, loaded, source ? source->most() : seeds.count, purpose, scheduler);
  announce_memory(loaded.input.file.string(), start.memory_estimate);

  progress.stage("building the " + name_of(graph_kind_names, kind) + " graph");
  const Stopwatch whole;
  if (purpose.has_dual && !has_triangles(kind)) {
    start.surface = {find_topology(loaded.input.mesh(), loaded.edges, scheduler),
                     irregular_edges(loaded.edges)};
  }
  MeshGraphOptions options = graph_options(arguments.graph, loaded, scheduler);
  start.input = std::move(loaded.input);
  MeshEdges edges = std::move(loaded.edges);
  const std::vector<SeedPlace> places = find_first_places(seeds, options, edges, start, scheduler);
  keep_for_arcs(edges, kind);
  start.mesh_graph = make_mesh_graph(start.input.mesh(), std::move(edges), options, scheduler);
  start.seconds.load = loaded.seconds;
  start.seconds.graph = loaded.edge_seconds + whole.seconds() - start.seconds.seeds;

  progress.stage("choosing seeds");
  const Stopwatch choosing;
  const Components components = connected_components(start.mesh_graph.graph);
  start.components = components.size();
  GivenSeeds given =
      first_seeds(seeds, source, start, places, options.vertex_space, components, scheduler);
  start.seeds = std::move(given.nodes);
  start.seed_fit = given.fit;
  start.seconds.seeds += choosing.seconds();
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
