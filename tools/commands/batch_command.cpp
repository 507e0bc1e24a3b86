#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <memory>
#include <utility>

#include "core/base/errors.h"
#include "core/graph/components.h"
#include "core/graph/mesh_graph.h"
#include "core/seeds/seed_places.h"
#include "core/seeds/seeds.h"
#include "parallel/engine/parallel_growing_search.h"
#include "tools/cli/choice_option.h"
#include "tools/cli/number_option.h"
#include "tools/commands/commands.h"
#include "tools/experiments/batch.h"
#include "tools/experiments/experiment.h"
#include "tools/run/measured_run.h"
#include "tools/run/stages.h"
#include "tools/system/interrupt.h"
#include "tools/words/facts_text.h"
#include "tools/words/text_table.h"

namespace geolloyd {
namespace {

const std::vector<Named<bool>> switch_names = {{"on", true}, {"off", false}};

struct BatchArguments {
  RelaxArguments relax;
  std::vector<std::string> seeds;
  std::size_t batches = 3;
  std::vector<std::string> graphs = names_of(graph_kind_names);
  std::vector<std::string> greedy = names_of(greedy_mode_names);
  std::vector<std::string> macrostep_skip = names_of(switch_names);
  std::vector<std::string> microstep_skip = names_of(switch_names);
  ExperimentOutput output;
};

using Triangles = std::vector<std::uint32_t>;

/// The first seeds of one batch, as triangles.
struct Start {
  std::size_t seeds;
  std::size_t batch;  // from 1
  Triangles places;
};

// That a batch can have so many first seeds.
void check_first_seeds(std::size_t seeds, std::size_t triangles, std::size_t components) {
  if (seeds < components) {
    throw InvalidInput(fmt::format(
        "{}: first seeds are chosen as triangles, and these are in {} parts that no edge "
        "joins: each needs a seed",
        counted(seeds, "seed", "seeds"), grouped(components)));
  }
  if (seeds > triangles) {
    throw InvalidInput(fmt::format("{}: this mesh has only {} to choose first seeds from",
                                   counted(seeds, "seed", "seeds"),
                                   counted(triangles, "triangle", "triangles")));
  }
}

// Chosen on the triangle graph, each batch by a random seed of its own.
std::vector<Start> choose_starts(const BatchArguments& a, const std::vector<std::size_t>& ladder,
                                 const Mesh& mesh, const MeshEdges& edges, Scheduler& scheduler) {
  MeshGraphOptions options;
  options.kind = GraphKind::triangle;
  const MeshGraph made = make_mesh_graph(mesh, edges, options, scheduler);
  const Components components = connected_components(made.graph);
  std::vector<Start> starts;
  for (const std::size_t k : ladder) {
    check_first_seeds(k, made.graph.node_count(), components.size());
    for (std::size_t batch = 1; batch <= a.batches; ++batch) {
      Start start{k, batch, {}};
      for (const NodeId s :
           choose_seeds(made.graph, components, value_of(seed_init_names, a.relax.init), k,
                        a.relax.random_seed + batch - 1,
                        *make_parallel_growing_search(scheduler, made.graph))) {
        start.places.push_back(made.input_id[s]);
      }
      starts.push_back(std::move(start));
    }
  }
  return starts;
}

// Before any work: are there enough vertices everywhere?
void check_starts(const std::vector<Start>& starts, const Mesh& mesh, const MeshEdges& edges,
                  Scheduler& scheduler) {
  const MeshGraph made = make_mesh_graph(mesh, edges, {}, scheduler);
  for (const Start& start : starts) seeds_at_triangles(mesh, made, start.places);
}

// All there are for one graph and number of seeds.
std::vector<BatchRow> empty_rows(const BatchArguments& a, const std::string& graph,
                                 std::size_t seeds) {
  std::vector<BatchRow> rows;
  for (const std::string& greedy : a.greedy) {
    for (const std::string& macro : a.macrostep_skip) {
      for (const std::string& micro : a.microstep_skip) {
        rows.emplace_back();
        rows.back().configuration = {graph, seeds, greedy, value_of(switch_names, macro),
                                     value_of(switch_names, micro)};
      }
    }
  }
  return rows;
}

RelaxationOptions options_of(const RelaxArguments& limits, const Configuration& c) {
  RelaxationOptions options = relaxation_options(limits);
  options.greedy = value_of(greedy_mode_names, c.greedy);
  options.macrostep_skip = c.macrostep_skip;
  options.microstep_skip = c.microstep_skip;
  return options;
}

class Batches {
 public:
  Batches(const BatchArguments& arguments, RunRecord& run, Scheduler& scheduler,
          ProgressLine& progress)
      : arguments_(arguments), run_(run), scheduler_(scheduler), progress_(progress) {}

  /// Calls `save` with all rows so far after each graph and number of seeds.
  std::vector<BatchRow> run(const std::function<void(const std::vector<BatchRow>&)>& save) {
    const std::vector<std::size_t> ladder = seed_ladder(arguments_.seeds);
    progress_.stage("reading " + run_.arguments.mesh.string());
    const MeshEdges edges = load_mesh(run_, scheduler_);
    check(ladder);
    progress_.stage("choosing seeds");
    starts_ = choose_starts(arguments_, ladder, run_.input.mesh, edges, scheduler_);
    check_starts(starts_, run_.input.mesh, edges, scheduler_);
    catch_interrupts();  // before the folder appears, which tells others that it is done
    prepare_output(arguments_.output, "batch", run_.arguments);
    std::vector<BatchRow> rows;
    for (const std::string& graph : arguments_.graphs) {
      run_.arguments.graph = graph;
      progress_.stage("building the " + graph + " graph");
      // Numbers of seeds differ; none takes more memory than one seed, whose region is all.
      build_graph(run_, scheduler_, edges, 1);
      for (const std::size_t k : ladder) {
        for (BatchRow& row : run_from(graph, k)) rows.push_back(row);
        save(rows);
        if (interrupted()) return rows;
      }
    }
    return rows;
  }

 private:
  void check(const std::vector<std::size_t>& ladder) const {
    for (const std::size_t k : ladder) {
      if (k <= run_.facts.vertices) continue;
      throw InvalidInput(fmt::format("{} seeds: this mesh has only {}", grouped(k),
                                     counted(run_.facts.vertices, "vertex", "vertices")));
    }
  }

  std::vector<BatchRow> run_from(const std::string& graph, std::size_t seeds) {
    std::vector<BatchRow> rows = empty_rows(arguments_, graph, seeds);
    for (const Start& start : starts_) {
      if (start.seeds != seeds) continue;
      const std::vector<NodeId> first =
          seeds_at_triangles(run_.input.mesh, run_.mesh_graph, start.places);
      for (BatchRow& row : rows) {
        if (!interrupted()) run_one(row, start, first);
      }
    }
    std::erase_if(rows, [](const BatchRow& row) { return row.batches == 0; });
    return rows;
  }

  void run_one(BatchRow& row, const Start& start, const std::vector<NodeId>& first) {
    const Configuration& c = row.configuration;
    const RelaxArguments& a = arguments_.relax;
    progress_.part(fmt::format("{}, {}, batch {}, {}, skips {} {}:", c.graph,
                               counted(c.seeds, "seed", "seeds"), start.batch, c.greedy,
                               name_of(switch_names, c.macrostep_skip),
                               name_of(switch_names, c.microstep_skip)));
    const MeasuredRun measured = measure_run(
        value_of(engine_names, a.engine), value_of(frontier_names, a.frontier), scheduler_,
        run_.mesh_graph.graph, first, options_of(a, c), watcher(progress_, first.size()));
    if (measured.relaxation.stop_reason == StopReason::interrupted) return;
    row.add(measured.relaxation, measured.seconds);
  }

  const BatchArguments& arguments_;
  RunRecord& run_;
  Scheduler& scheduler_;
  ProgressLine& progress_;
  std::vector<Start> starts_;
};

std::string table_of(const std::vector<BatchRow>& rows) {
  TextTable table({"graph", "greedy", "macro skip", "micro skip", "seeds", "batches", "mean time",
                   "from", "to", "greedy steps", "macrosteps", "microsteps", "energy"},
                  4);
  const auto on = [](bool value) { return value ? "on" : "off"; };
  for (const BatchRow& row : rows) {
    const Configuration& c = row.configuration;
    table.add({c.graph, c.greedy, on(c.macrostep_skip), on(c.microstep_skip), grouped(c.seeds),
               std::to_string(row.batches), duration_text(row.seconds.mean()),
               duration_text(row.seconds.min()), duration_text(row.seconds.max()),
               fmt::format("{:.1f}", row.greedy_steps.mean()),
               fmt::format("{:.1f}", row.macrosteps.mean()),
               fmt::format("{:.1f}", row.microsteps.mean()),
               fmt::format("{:.6g}", row.energy.mean())});
  }
  return table.text();
}

Json result_of(const BatchArguments& a, const RunRecord& run, std::size_t threads, const Json& rows,
               bool is_complete) {
  const bool parallel = value_of(engine_names, a.relax.engine) == EngineKind::parallel;
  Json result = begin_result("batch", run);
  result["options"] = options_part(run.arguments, 0);
  result["options"].update(Json{{"graph", a.graphs},
                                {"seeds", seed_ladder(a.seeds)},
                                {"greedy", a.greedy},
                                {"macrostep_skip", a.macrostep_skip},
                                {"microstep_skip", a.microstep_skip},
                                {"batches", a.batches},
                                {"engine", a.relax.engine},
                                {"threads", parallel ? threads : 1},
                                {"frontier", parallel ? Json(a.relax.frontier) : Json(nullptr)},
                                {"backend", parallel ? Json(a.relax.backend) : Json(nullptr)}});
  result["interrupted"] = !is_complete;
  result["rows"] = rows;
  return result;
}

void run_batch(BatchArguments& arguments) {
  for (auto* list : {&arguments.graphs, &arguments.greedy, &arguments.macrostep_skip,
                     &arguments.microstep_skip}) {
    drop_repeats(*list);
  }
  RunRecord run;
  run.arguments = arguments.relax;
  ProgressLine progress;
  Scheduler scheduler = make_scheduler(run.arguments);
  const auto save = [&](const std::vector<BatchRow>& rows, bool is_complete) {
    Json json = Json::array();
    for (const BatchRow& row : rows) json.push_back(row_json(row));
    save_result(arguments.output, "batch", json,
                result_of(arguments, run, scheduler.threads(), json, is_complete));
  };
  const std::vector<BatchRow> rows =
      Batches(arguments, run, scheduler, progress).run([&](const std::vector<BatchRow>& so_far) {
        save(so_far, false);
      });
  save(rows, !interrupted());
  progress.clear();
  fmt::print("{}: {}, {}\n", run.arguments.mesh.string(),
             counted(run.facts.vertices, "vertex", "vertices"),
             counted(run.facts.triangles, "triangle", "triangles"));
  print_machine();
  fmt::print("{}\nmeans over batches, {} engine\n", table_of(rows), arguments.relax.engine);
  finish_experiment(arguments.output, "batch");
  if (interrupted()) throw InterruptedExit{};
}

template <class Choice>
void add_list(CLI::App& command, const char* name, std::vector<std::string>& list, const char* what,
              const std::vector<Named<Choice>>& choices) {
  one_of(command.add_option(name, list, what), choices)
      ->delimiter(',')
      ->allow_extra_args(false)
      ->group("What to vary (lists, separated by commas; default: all)");
}

}  // namespace

void add_batch_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "batch",
      "Relax from many first seeds, in all graphs and with all options: the thesis's experiment");
  const auto a = std::make_shared<BatchArguments>();
  add_mesh_argument(*command, a->relax);
  command
      ->add_option("-k,--seeds", a->seeds,
                   "Numbers of seeds: 1024, or 16,1024, or 4..1024 for 4, 8, 16... 1024")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NUMBERS")
      ->required();
  whole_number(
      command->add_option("--batches", a->batches, "How many times to choose other first seeds"), 1,
      100'000)
      ->capture_default_str();
  add_output_options(*command, a->output, "batch");
  add_list(*command, "--graphs", a->graphs, "Kinds of graph", graph_kind_names);
  add_list(*command, "--greedy", a->greedy, "Heuristics of the greedy phase", greedy_mode_names);
  add_list(*command, "--macrostep-skip", a->macrostep_skip,
           "Keep seeds of regions whose score did not change", switch_names);
  add_list(*command, "--microstep-skip", a->microstep_skip,
           "Search only regions whose seed moved: changes the reference's time, no result",
           switch_names);
  add_engine_option(*command, a->relax);
  a->relax.init = "random-area";
  add_init_options(*command, a->relax);
  add_metric_options(*command, a->relax);
  add_limit_options(*command, a->relax);
  add_thread_options(*command, a->relax);
  command->footer(
      "First seeds are chosen as triangles, and lie there or at their corners in all graphs.");
  command->callback([a] { run_batch(*a); });
}

}  // namespace geolloyd
