#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <utility>

#include "tools/cli/choice_option.h"
#include "tools/cli/number_option.h"
#include "tools/cli/reading_options.h"
#include "tools/cli/relax_arguments.h"
#include "tools/laboratory/batch_runs.h"
#include "tools/laboratory/laboratory.h"
#include "tools/report/heading.h"
#include "tools/run/stages.h"
#include "tools/system/interrupt.h"
#include "tools/words/facts_text.h"
#include "tools/words/text_table.h"

namespace geolloyd {
namespace {

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
  result["options"] =
      options_part(a.start, relaxation_options(a.start.seeds, a.start.seed_file, a.limits), 0);
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

void run_batch(BatchArguments& arguments, const Console& console) {
  drop_repeats(arguments.graphs);
  drop_repeats(arguments.greedy);
  drop_repeats(arguments.macrostep_skip);
  drop_repeats(arguments.microstep_skip);
  ProgressLine progress(console);
  Scheduler scheduler = make_scheduler(arguments.threads);
  std::vector<std::size_t> ladder = seed_ladder(arguments.seeds);
  progress.stage("reading " + arguments.start.mesh.string());
  const LoadedInput loaded =
      load_input(arguments.start.mesh, scheduler, {false, arguments.start.reading});
  const Input& input = loaded.input;
  BatchRuns batches(arguments, std::move(ladder), loaded, scheduler, progress);
  catch_interrupts();  // before the folder appears, which tells others that it is done
  const MadeFolders folders = prepare_output(arguments.output, "batch", arguments.start);
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
  finish_experiment(arguments.output, "batch", result, console);
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

void add_batch_command(CLI::App& program, Console& console) {
  CLI::App* command = program.add_subcommand(
      "batch", "Run the thesis's experiment: many first seeds, all graphs, all heuristics");
  const auto a = std::make_shared<BatchArguments>();
  add_mesh_argument(*command, a->start.mesh);
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
  add_output_options(*command, a->output, "batch", console);
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
  add_reading_options(*command, a->start.reading);
  command->footer(
      "First seeds are chosen as triangles. A graph without triangles takes a corner of each.");
  command->callback([a, &console] { run_batch(*a, console); });
}

}  // namespace geolloyd
