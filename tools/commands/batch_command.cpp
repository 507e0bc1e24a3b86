#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <memory>
#include <utility>

#include "core/graph/mesh_graph.h"
#include "core/seeds/seed_places.h"
#include "geolloyd/errors.h"
#include "tools/cli/choice_option.h"
#include "tools/cli/number_option.h"
#include "tools/commands/commands.h"
#include "tools/experiments/batch.h"
#include "tools/experiments/experiment.h"
#include "tools/experiments/first_seeds.h"
#include "tools/run/measured_run.h"
#include "tools/run/stages.h"
#include "tools/run/work_queue.h"
#include "tools/system/interrupt.h"
#include "tools/system/memory_limit.h"
#include "tools/words/facts_text.h"
#include "tools/words/text_table.h"

namespace geolloyd {
namespace {

const std::vector<Named<bool>> switch_names = {{"on", true}, {"off", false}};

struct BatchArguments {
  StartArguments start;  // but for the number of seeds and the kind of graph
  RelaxationArguments limits;
  EngineArguments engine;
  ThreadArguments threads;
  std::vector<std::string> seeds;
  std::size_t batches = 3;
  bool together = false;
  std::vector<GraphKind> graphs = {GraphKind::vertex, GraphKind::vertex_dense, GraphKind::triangle,
                                   GraphKind::triangle_dense, GraphKind::mixed};  // the thesis's
  std::vector<GreedyMode> greedy = values_of(greedy_mode_names);
  std::vector<bool> macrostep_skip = values_of(switch_names);
  std::vector<bool> microstep_skip = values_of(switch_names);
  ExperimentOutput output;
};

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
  RelaxationOptions options = relaxation_options({}, limits);
  options.greedy = c.greedy;
  options.macrostep_skip = c.macrostep_skip;
  options.microstep_skip = c.microstep_skip;
  return options;
}

class Batches {
 public:
  /// All must live on. Chooses the first seeds of all batches.
  Batches(const BatchArguments& arguments, std::vector<std::size_t> ladder,
          const LoadedInput& loaded, Scheduler& scheduler, ProgressLine& progress)
      : arguments_(arguments),
        ladder_(std::move(ladder)),
        loaded_(loaded),
        scheduler_(scheduler),
        progress_(progress) {
    check_ladder();
    progress_.stage("choosing seeds");
    const Mesh& mesh = loaded_.input.mesh();
    starts_ = choose_first_seeds(arguments_.start.seeds, ladder_, arguments_.batches, mesh,
                                 loaded_.edges, scheduler_);
  }

  /// Calls `save` with all rows so far after each graph and number of seeds.
  std::vector<BatchRow> run(const std::function<void(const std::vector<BatchRow>&)>& save) {
    std::vector<BatchRow> rows;
    for (const GraphKind graph : arguments_.graphs) {
      progress_.stage("building the " + name_of(graph_kind_names, graph) + " graph");
      GraphArguments as_asked = arguments_.start.graph;
      as_asked.kind = graph;
      const std::size_t most_seeds = *std::max_element(ladder_.begin(), ladder_.end());
      const BuiltGraph built = build_graph(as_asked, loaded_, most_seeds, scheduler_);
      const MeshGraph& mesh_graph = built.mesh_graph;
      bytes_of_run_ = built.memory_estimate;
      for (const std::size_t k : ladder_) {
        for (BatchRow& row : run_from(mesh_graph, k)) rows.push_back(row);
        save(rows);
        if (interrupted()) return rows;
      }
    }
    return rows;
  }

 private:
  void check_ladder() const {
    const std::size_t vertices = loaded_.input.facts.vertices;
    for (const std::size_t k : ladder_) {
      if (k <= vertices) continue;
      throw InvalidInput(fmt::format("{} seeds: this mesh has only {}", grouped(k),
                                     counted(vertices, "vertex", "vertices")));
    }
  }

  std::vector<BatchRow> run_from(const MeshGraph& mesh_graph, std::size_t seeds) {
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

  void run_in_turn(std::vector<BatchRow>& rows, const Graph& graph, const FirstSeeds& start,
                   const std::vector<NodeId>& first) {
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
  void run_together(std::vector<BatchRow>& rows, const Graph& graph, const FirstSeeds& start,
                    const std::vector<NodeId>& first) {
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

  MeasuredRun run_one(const Configuration& c, const Graph& graph, const std::vector<NodeId>& first,
                      Scheduler& scheduler, const ProgressCallback& observer) const {
    const EngineArguments& engine = arguments_.engine;
    return measure_run(engine.kind, engine.frontier, scheduler, graph, first,
                       options_of(arguments_.limits, c), observer);
  }

  static void add(BatchRow& row, const MeasuredRun& run) {
    if (run.relaxation.stop_reason == StopReason::interrupted) return;
    row.add(run.relaxation, run.seconds);
  }

  static std::string describe(const Configuration& c, const FirstSeeds& start) {
    return fmt::format("{}, {}, batch {}", name_of(graph_kind_names, c.graph),
                       counted(c.seeds, "seed", "seeds"), start.batch);
  }

  const BatchArguments& arguments_;
  std::vector<std::size_t> ladder_;
  const LoadedInput& loaded_;
  Scheduler& scheduler_;
  ProgressLine& progress_;
  std::vector<FirstSeeds> starts_;
  std::uint64_t bytes_of_run_ = 0;  // at most
};

std::string table_of(const std::vector<BatchRow>& rows) {
  TextTable table({"graph", "greedy", "macro skip", "micro skip", "seeds", "batches", "mean time",
                   "from", "to", "greedy steps", "macrosteps", "microsteps", "energy"},
                  4);
  for (const BatchRow& row : rows) {
    const Configuration& c = row.configuration;
    table.add({name_of(graph_kind_names, c.graph), name_of(greedy_mode_names, c.greedy),
               name_of(switch_names, c.macrostep_skip), name_of(switch_names, c.microstep_skip),
               grouped(c.seeds), std::to_string(row.batches), duration_text(row.seconds.mean()),
               duration_text(row.seconds.min()), duration_text(row.seconds.max()),
               fmt::format("{:.1f}", row.greedy_steps.mean()),
               fmt::format("{:.1f}", row.macrosteps.mean()),
               fmt::format("{:.1f}", row.microsteps.mean()),
               fmt::format("{:.6g}", row.energy.mean())});
  }
  return table.text();
}

Json result_of(const BatchArguments& a, const Input& input, std::size_t threads, const Json& rows,
               bool is_complete) {
  const EngineKind engine = a.engine.kind;
  Json result = begin_result("batch", input);
  result["options"] = options_part(a.start, a.limits, 0);
  result["options"].update(Json{{"graph", names_of(graph_kind_names, a.graphs)},
                                {"seeds", seed_ladder(a.seeds)},
                                {"greedy", names_of(greedy_mode_names, a.greedy)},
                                {"macrostep_skip", names_of(switch_names, a.macrostep_skip)},
                                {"microstep_skip", names_of(switch_names, a.microstep_skip)},
                                {"batches", a.batches},
                                {"engine", name_of(engine_names, engine)},
                                {"threads", engine == EngineKind::reference ? 1 : threads},
                                {"together", a.together},
                                {"frontier", frontier_part(engine, a.engine.frontier)},
                                {"backend", backend_part(engine, a.threads.backend)}});
  result["interrupted"] = !is_complete;
  result["rows"] = rows;
  return result;
}

void run_batch(BatchArguments& arguments) {
  drop_repeats(arguments.graphs);
  drop_repeats(arguments.greedy);
  drop_repeats(arguments.macrostep_skip);
  drop_repeats(arguments.microstep_skip);
  ProgressLine progress;
  Scheduler scheduler = make_scheduler(arguments.threads);
  std::vector<std::size_t> ladder = seed_ladder(arguments.seeds);
  progress.stage("reading " + arguments.start.mesh.string());
  const LoadedInput loaded = load_input(arguments.start.mesh, scheduler);
  const Input& input = loaded.input;
  Batches batches(arguments, std::move(ladder), loaded, scheduler, progress);
  catch_interrupts();  // before the folder appears, which tells others that it is done
  prepare_output(arguments.output, "batch", arguments.start);
  const auto save = [&](const std::vector<BatchRow>& rows, bool is_complete) {
    Json json = Json::array();
    for (const BatchRow& row : rows) json.push_back(row_json(row));
    Json result = result_of(arguments, input, scheduler.threads(), json, is_complete);
    save_result(arguments.output, "batch", json, result);
    return result;
  };
  const std::vector<BatchRow> rows =
      batches.run([&](const std::vector<BatchRow>& so_far) { save(so_far, false); });
  const Json result = save(rows, !interrupted());
  progress.clear();
  fmt::print("{}: {}, {}\n", input.file.string(),
             counted(input.facts.vertices, "vertex", "vertices"),
             counted(input.facts.triangles, "triangle", "triangles"));
  print_machine();
  fmt::print("{}\nmeans over batches, {} engine\n", table_of(rows),
             name_of(engine_names, arguments.engine.kind));
  finish_experiment(arguments.output, "batch", result);
  if (interrupted()) throw InterruptedExit{};
}

template <class Choice>
void add_list(CLI::App& command, const char* name, std::vector<Choice>& list, const char* what,
              const std::vector<Named<Choice>>& choices) {
  add_choice_list(command, name, list, choices, what)
      ->default_str("")
      ->group("What to vary (lists, separated by commas; default: all)");
}

}  // namespace

void add_batch_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "batch", "Run the thesis's experiment: many first seeds, all graphs, all heuristics");
  const auto a = std::make_shared<BatchArguments>();
  add_mesh_argument(*command, a->start);
  command
      ->add_option("-k,--seeds", a->seeds,
                   "Numbers of seeds: 1024, or 16,1024, or 4..1024 for 4, 8, 16... 1024")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NUMBERS")
      ->required();
  whole_number(command->add_option("--batches", a->batches, "Number of sets of first seeds"), 1,
               100'000)
      ->capture_default_str();
  command->add_flag("--together", a->together,
                    "Do as many runs at once as there are threads, each with one: times\n"
                    "are then those of runs that others slow down");
  add_output_options(*command, a->output, "batch");
  add_list(*command, "--graphs", a->graphs, "Kinds of graph", graph_kind_names);
  add_list(*command, "--greedy", a->greedy, "Heuristics of the greedy phase", greedy_mode_names);
  add_list(*command, "--macrostep-skip", a->macrostep_skip,
           "Keep seeds of regions whose score did not change", switch_names);
  add_list(*command, "--microstep-skip", a->microstep_skip,
           "Search only regions whose seed moved; changes the reference's time, never a result",
           switch_names);
  add_engine_option(*command, a->engine.kind);
  a->start.seeds.init = SeedInit::random_area;
  add_init_options(*command, a->start.seeds);
  add_metric_options(*command, a->start.graph);
  add_limit_options(*command, a->limits);
  add_frontier_option(*command, a->engine);
  add_thread_options(*command, a->threads);
  command->footer(
      "First seeds are chosen as triangles. A graph without triangles takes a corner of each.");
  command->callback([a] { run_batch(*a); });
}

}  // namespace geolloyd
