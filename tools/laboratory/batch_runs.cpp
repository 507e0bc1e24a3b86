#include "tools/laboratory/batch_runs.h"

#include <fmt/format.h>

#include <utility>

#include "core/seeds/seed_places.h"
#include "geolloyd/errors.h"
#include "tools/run/stages.h"
#include "tools/run/work_queue.h"
#include "tools/system/interrupt.h"
#include "tools/system/memory_limit.h"
#include "tools/words/facts_text.h"

namespace geolloyd {
namespace {

// All there are for one graph and number of seeds.
std::vector<BatchRow> empty_rows(const BatchArguments& a, GraphKind graph, std::size_t seeds) {
  std::vector<BatchRow> rows;
  for (const GreedyMode greedy : a.greedy) {
    for (const bool macro : a.macrostep_skip) {
      for (const bool micro : a.microstep_skip) {
        rows.emplace_back();
        rows.back().configuration = {graph, seeds, greedy, macro, micro};
      }
    }
  }
  return rows;
}

RelaxationOptions options_of(const RelaxationArguments& limits, const Configuration& c) {
  RelaxationOptions options = relaxation_options({}, {}, limits);
  options.greedy = c.greedy;
  options.macrostep_skip = c.macrostep_skip;
  options.microstep_skip = c.microstep_skip;
  return options;
}

void add(BatchRow& row, const MeasuredRun& run) {
  if (run.relaxation.stop_reason == StopReason::interrupted) return;
  row.add(run.relaxation, run.seconds);
}

std::string describe(const Configuration& c, const FirstSeeds& start) {
  return fmt::format("{}, {}, batch {}", name_of(graph_kind_names, c.graph),
                     counted(c.seeds, "seed", "seeds"), start.batch);
}

}  // namespace

BatchRuns::BatchRuns(const BatchArguments& arguments, std::vector<std::size_t> ladder,
                     const LoadedInput& loaded, Scheduler& scheduler, ProgressLine& progress)
    : arguments_(arguments),
      ladder_(std::move(ladder)),
      loaded_(loaded),
      scheduler_(scheduler),
      progress_(progress) {
  check_ladder();
  progress_.stage("choosing seeds");
  starts_ = choose_first_seeds(
      arguments_.start.seeds, ladder_, arguments_.batches, loaded_.input.mesh(), loaded_.edges,
      *make_runtime(EngineKind::parallel, Frontier::automatic, scheduler_));
}

std::vector<BatchRow> BatchRuns::run(
    const std::function<void(const std::vector<BatchRow>&)>& save) {
  std::vector<BatchRow> rows;
  for (const GraphKind kind : arguments_.graphs) {
    progress_.stage("building the " + name_of(graph_kind_names, kind) + " graph");
    const MeshGraph mesh_graph = build_graph(kind);
    for (const std::size_t k : ladder_) {
      for (BatchRow& row : run_from(mesh_graph, k)) rows.push_back(row);
      save(rows);
      if (interrupted()) return rows;
    }
  }
  return rows;
}

void BatchRuns::check_ladder() const {
  const std::size_t vertices = loaded_.input.facts.vertices;
  for (const std::size_t k : ladder_) {
    if (k <= vertices) continue;
    throw InvalidInput(fmt::format("{} seeds: this mesh has only {}", grouped(k),
                                   counted(vertices, "vertex", "vertices")));
  }
}

MeshGraph BatchRuns::build_graph(GraphKind kind) {
  GraphPlan graph = arguments_.start.graph;
  graph.kind = kind;
  const Input& input = loaded_.input;
  bytes_of_run_ = 0;
  const auto [fewest, most] = std::minmax_element(ladder_.begin(), ladder_.end());
  for (const std::size_t seeds : {*fewest, *most}) {  // the largest regions, the most of them
    bytes_of_run_ = std::max(bytes_of_run_, estimate_memory(graph, {seeds, SeedInit::farthest},
                                                            input, loaded_.edges, {}, scheduler_));
  }
  progress_.announce_memory(input.file.string(), bytes_of_run_);
  MeshGraphOptions options = graph_options(graph, input.mesh(), loaded_.edges, scheduler_);
  options.welded_to = input.loaded.welded_to;
  return make_mesh_graph(input.mesh(), loaded_.edges, options, scheduler_);
}

std::vector<BatchRow> BatchRuns::run_from(const MeshGraph& mesh_graph, std::size_t seeds) {
  std::vector<BatchRow> rows = empty_rows(arguments_, mesh_graph.kind, seeds);
  for (const FirstSeeds& start : starts_) {
    if (start.seeds != seeds) continue;
    const std::vector<NodeId> first =
        seeds_at_triangles(loaded_.input.mesh(), mesh_graph, start.places);
    if (arguments_.together) {
      run_together(rows, mesh_graph.graph, start, first);
    } else {
      run_in_turn(rows, mesh_graph.graph, start, first);
    }
  }
  std::erase_if(rows, [](const BatchRow& row) { return row.batches == 0; });
  return rows;
}

void BatchRuns::run_in_turn(std::vector<BatchRow>& rows, const Graph& graph,
                            const FirstSeeds& start, const std::vector<NodeId>& first) {
  for (BatchRow& row : rows) {
    if (interrupted()) return;
    const Configuration& c = row.configuration;
    progress_.part(fmt::format(
        "{}, {}, skips {} {}:", describe(c, start), name_of(greedy_mode_names, c.greedy),
        name_of(switch_names, c.macrostep_skip), name_of(switch_names, c.microstep_skip)));
    add(row, run_one(c, graph, first, scheduler_, watcher(progress_, first.size())));
  }
}

// Rows add up in their order, whichever run ends first.
void BatchRuns::run_together(std::vector<BatchRow>& rows, const Graph& graph,
                             const FirstSeeds& start, const std::vector<NodeId>& first) {
  progress_.stage(describe(rows.front().configuration, start) + ": all settings");
  std::vector<MeasuredRun> runs(rows.size());
  for (MeasuredRun& run : runs) run.relaxation.stop_reason = StopReason::interrupted;
  WorkQueue queue(std::vector<QueuedWork>(rows.size(), {1, bytes_of_run_}), allowed_memory(),
                  scheduler_);
  queue.run([&](std::size_t n, MemoryShare&) {
    Scheduler one(1, scheduler_.backend());
    runs[n] = run_one(rows[n].configuration, graph, first, one,
                      [](const Progress&) { return !interrupted(); });
  });
  for (std::size_t n = 0; n < rows.size(); ++n) add(rows[n], runs[n]);
}

MeasuredRun BatchRuns::run_one(const Configuration& c, const Graph& graph,
                               const std::vector<NodeId>& first, Scheduler& scheduler,
                               const ProgressCallback& observer) const {
  const EngineArguments& engine = arguments_.engine;
  const auto runtime = make_runtime(engine.kind, engine.frontier, scheduler);
  return measure_run(graph, first, options_of(arguments_.limits, c), observer, *runtime);
}

}  // namespace geolloyd
