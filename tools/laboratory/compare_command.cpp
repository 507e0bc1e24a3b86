#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <stdexcept>

#include "tools/cli/choice_option.h"
#include "tools/cli/number_option.h"
#include "tools/cli/reading_options.h"
#include "tools/cli/relax_arguments.h"
#include "tools/laboratory/comparison.h"
#include "tools/laboratory/experiment.h"
#include "tools/laboratory/laboratory.h"
#include "tools/report/heading.h"
#include "tools/run/stages.h"
#include "tools/system/interrupt.h"
#include "tools/words/facts_text.h"
#include "tools/words/text_table.h"

namespace geolloyd {
namespace {

struct CompareArguments {
  RunRequest start;
  RelaxationArguments relaxation;
  std::vector<std::size_t> threads;  // none: 1, 2, 4... up to all the machine has
  std::vector<Frontier> frontiers = {Frontier::regions};
  std::vector<Backend> backends = {Backend::tbb};
  std::size_t turns = 3;
  bool no_reference = false;
  ExperimentOutput output;
};

std::vector<Contender> contenders_of(const CompareArguments& a) {
  std::vector<Contender> contenders;
  if (!a.no_reference) contenders.push_back({EngineKind::reference, {}, {}, 1, {}});
  for (const Frontier frontier : a.frontiers) {
    for (const Backend backend : a.backends) {
      for (const std::size_t threads : a.threads.empty() ? thread_ladder() : a.threads) {
        contenders.push_back({EngineKind::parallel, frontier, backend, threads, {}});
      }
    }
  }
  return contenders;
}

std::string plain(std::optional<double> value) {
  return value ? fmt::format("{:.2f}", *value) : "";
}

std::string table_of(const Comparison& comparison) {
  TextTable table({"", "turns", "median", "from", "to", "M visits/s", "speed-up", "efficiency",
                   "MB", "fingerprint", ""},
                  1);
  const auto visits = static_cast<double>(comparison.steps.node_visits);
  for (const Contender& c : comparison.contenders) {
    table.add({title_of(c), std::to_string(c.seconds.size()), duration_text(c.median()),
               duration_text(c.seconds.front()), duration_text(c.seconds.back()),
               fmt::format("{:.2f}", visits / c.median() * 1e-6), plain(comparison.speedup(c)),
               plain(comparison.efficiency(c)),
               fmt::format("{:.0f}", static_cast<double>(c.peak_memory_bytes) * 1e-6),
               fingerprint_text(c.fingerprint), comparison.is_equal(c) ? "equal" : "DIFFERENT"});
  }
  return table.text();
}

void print_comparison(const PreparedInput& start, const Comparison& comparison) {
  const StepCounts& steps = comparison.steps;
  print_heading(start);
  fmt::print("{}\n", table_of(comparison));
  fmt::print("{}, {} of {}, {} by definition\n",
             counted(steps.greedy, "greedy step", "greedy steps"),
             counted(steps.macro, "macrostep", "macrosteps"),
             counted(steps.micro, "microstep", "microsteps"),
             counted(steps.node_visits, "node visit", "node visits"));
}

Json result_of(const CompareArguments& a, const PreparedInput& start, const Comparison& comparison,
               const Json& rows) {
  Json result = begin_result("compare", start.input);
  result["options"] =
      options_part(a.start, relaxation_options(a.start.seeds, a.start.seed_file, a.relaxation),
                   start.seeds.size());
  result["interrupted"] = interrupted();
  result["graph"] = graph_part(start.mesh_graph.graph, start.components);
  result["seed_fit"] = seed_fit_part(start.seed_fit);
  result["steps"] = steps_part(comparison.steps);
  result["runs"] = rows;
  return result;
}

void run_compare(CompareArguments& arguments, const Console& console) {
  drop_repeats(arguments.threads);
  drop_repeats(arguments.frontiers);
  drop_repeats(arguments.backends);
  check_seeds(arguments.start.seeds, arguments.start.seed_file);
  check_same_course(arguments.relaxation);
  ProgressLine progress(console);
  const PreparedInput start = [&] {
    Threads threads;
    return prepare(arguments.start, {}, threads, progress);
  }();
  catch_interrupts();  // before the folder appears, which tells others that it is done
  const MadeFolders folders = prepare_output(arguments.output, "compare", arguments.start);
  const Comparison comparison = compare(
      contenders_of(arguments), arguments.turns, start.mesh_graph.graph, start.seeds,
      relaxation_options(arguments.start.seeds, arguments.start.seed_file, arguments.relaxation),
      progress);
  progress.clear();
  const Json rows = rows_of(comparison);
  const Json result = result_of(arguments, start, comparison, rows);
  if (!comparison.contenders.empty()) {
    save_result(arguments.output, "compare", rows, result);
    print_comparison(start, comparison);
  }
  finish_experiment(arguments.output, "compare", result, console);
  for (const Contender& c : comparison.contenders) {
    if (!comparison.is_equal(c)) {
      throw std::runtime_error(title_of(c) +
                               " gave another result: geolloyd verify tells where they part");
    }
  }
  if (interrupted()) throw InterruptedExit{};
}

}  // namespace

void add_compare_command(CLI::App& program, Console& console) {
  CLI::App* command = program.add_subcommand(
      "compare", "Time the reference and the parallel engine, by threads, frontier and backend");
  const auto a = std::make_shared<CompareArguments>();
  add_mesh_argument(*command, a->start.mesh);
  add_output_options(*command, a->output, "compare", console);
  add_seed_options(*command, a->start.seeds, a->start.seed_file);
  add_graph_options(*command, a->start.graph);
  add_relaxation_options(*command, a->relaxation);
  const char* group = "What to compare (lists, separated by commas; all combinations)";
  whole_number(
      command->add_option("--threads", a->threads,
                          "Numbers of threads (default: 1,2,4... up to all that can run at once)"),
      1, most_threads)
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NUMBERS")
      ->group(group);
  add_choice_list(*command, "--frontiers", a->frontiers, frontier_names,
                  "Searches of the parallel engine")
      ->group(group);
  add_choice_list(*command, "--backends", a->backends, backend_names, "Threading libraries")
      ->group(group);
  whole_number(
      command->add_option("--turns", a->turns,
                          "Number of times that each is timed; the reference is timed once"),
      1, 1'000'000)
      ->capture_default_str()
      ->group(group);
  command
      ->add_flag("--no-reference", a->no_reference,
                 "Leave out the sequential reference, which is slow")
      ->group(group);
  add_reading_options(*command, a->start.reading);
  command->footer("Exit status 1 if a fingerprint differs. Times are those of the relaxation.");
  command->callback([a, &console] { run_compare(*a, console); });
}

}  // namespace geolloyd
