#include "tools/run/stages.h"

#include <string>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/graph/graph.h"
#include "core/library/reference_runtime.h"
#include "core/properties/properties.h"
#include "core/start/first_seeds.h"
#include "geolloyd/threads.h"
#include "tools/render/picture.h"
#include "tools/run/memory_need.h"
#include "tools/run/seed_source.h"
#include "tools/system/memory_limit.h"

namespace geolloyd {

std::uint64_t estimate_memory(const GraphPlan& graph, const SeedPlan& seeds, const Input& input,
                              const MeshEdges& edges, const RunWork& work, Executor& executor) {
  const Mesh& mesh = input.mesh();
  WorkSize size = size_of(input.loaded);
  size.sites = seeds.count;
  size.has_field = !graph.vfield.empty();
  size.has_cross_field = graph.has_cross_field();
  size.has_ground_truth = work.has_ground_truth;
  if (work.picture) {
    size.samples = count_samples(mesh, work.picture->view, work.picture->size, executor);
  }
  return memory_to_relax(mesh, edges, graph.kind, size, executor);
}

std::unique_ptr<Runtime> make_runtime(EngineKind kind, Frontier frontier, Scheduler& scheduler) {
  if (kind == EngineKind::reference) return std::make_unique<ReferenceRuntime>(scheduler);
  return std::make_unique<Threads>(scheduler, frontier);
}

PreparedInput prepare(const RunRequest& request, const RunWork& work, Runtime& runtime,
                      ProgressLine& progress) {
  Executor& executor = runtime.executor();
  progress.stage("reading " + request.mesh.string());
  LoadedInput loaded =
      load_input(request.mesh, executor, {request.has_properties, request.reading}, request.repair);
  const Mesh& mesh = loaded.input.mesh();
  SeedPlan seeds = request.seeds;
  std::optional<SeedSource> source;
  if (!request.seed_file.path.empty()) {
    source.emplace(request.seed_file);
    seeds = {source->most(), SeedInit::farthest};
  }
  const std::uint64_t estimate =
      estimate_memory(request.graph, seeds, loaded.input, loaded.edges, work, executor);
  progress.announce_memory(loaded.input.file.string(), estimate);
  if (source) {
    seeds.given = [&](const MeshGraph& mesh_graph, const Components& components) {
      return source->find(mesh_graph, components);
    };
  }
  CourseHooks hooks;
  hooks.stage = [&](const std::string& stage) { progress.stage(stage); };
  if (!request.graph.vfield.empty()) progress.stage("finding the tangent field");
  const Stopwatch finding;
  RunPlan plan{graph_options(request.graph, mesh, loaded.edges, executor), std::move(seeds),
               work.has_dual};
  plan.graph.welded_to = loaded.input.loaded.welded_to;
  const double edge_and_field_seconds = loaded.edge_seconds + finding.seconds();
  PreparedInput prepared{
      geolloyd::prepare(mesh, std::move(loaded.edges), plan, runtime, hooks), {}, 0, 0};
  prepared.seconds.graph += edge_and_field_seconds;
  prepared.input = std::move(loaded.input);
  prepared.memory_estimate = estimate;
  prepared.load_seconds = loaded.seconds;
  return prepared;
}

EnginePartition partition_seeds(const Graph& graph, std::span<const NodeId> seeds,
                                Runtime& runtime) {
  auto engine = runtime.make_engine(graph);
  engine->partition(seeds);
  Partition partition = engine->current();
  return {std::move(engine), std::move(partition)};
}

}  // namespace geolloyd
