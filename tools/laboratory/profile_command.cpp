#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#include "tools/cli/choice_option.h"
#include "tools/cli/reading_options.h"
#include "tools/cli/relax_arguments.h"
#include "tools/laboratory/experiment.h"
#include "tools/laboratory/laboratory.h"
#include "tools/laboratory/measured_run.h"
#include "tools/laboratory/profile.h"
#include "tools/report/heading.h"
#include "tools/run/stages.h"
#include "tools/system/interrupt.h"
#include "tools/words/facts_text.h"
#include "tools/words/text_table.h"

namespace geolloyd {
namespace {

struct ProfileArguments {
  RunRequest start;
  RelaxationArguments relaxation;
  EngineArguments engine;  // its frontier
  ThreadArguments threads;
  std::vector<EngineKind> engines = {EngineKind::reference, EngineKind::parallel};
  ExperimentOutput output;
};

struct EngineProfile {
  EngineKind engine;
  std::size_t threads;
  MeasuredRun run;
};

std::string title_of(const EngineProfile& profile) {
  return fmt::format("{}, {}", name_of(engine_names, profile.engine),
                     counted(profile.threads, "thread", "threads"));
}

std::string share_text(double part, double all) {
  return all > 0 ? fmt::format("{:.1f} %", 100 * part / all) : "";
}

std::string table_of(const EngineProfile& profile) {
  const PhaseProfile greedy = profile_of(profile.run.relaxation, Phase::greedy);
  const PhaseProfile precise = profile_of(profile.run.relaxation, Phase::precise);
  TextTable table({title_of(profile), "greedy", "", "precise", "", "both", ""}, 1);
  const auto add = [&](const std::string& title, double in_greedy, double in_precise) {
    const double greedy_all = total(greedy.seconds);
    const double precise_all = total(precise.seconds);
    table.add({title, duration_text(in_greedy), share_text(in_greedy, greedy_all),
               duration_text(in_precise), share_text(in_precise, precise_all),
               duration_text(in_greedy + in_precise),
               share_text(in_greedy + in_precise, greedy_all + precise_all)});
  };
  for (const auto& [name, kernel] : kernel_names) {
    std::string title = name;
    std::replace(title.begin(), title.end(), '_', ' ');
    add(title, greedy.seconds.*kernel, precise.seconds.*kernel);
  }
  add("all", total(greedy.seconds), total(precise.seconds));
  table.add({"node visits, millions", fmt::format("{:.1f}", double(greedy.node_visits) * 1e-6), "",
             fmt::format("{:.1f}", double(precise.node_visits) * 1e-6), "",
             fmt::format("{:.1f}", double(greedy.node_visits + precise.node_visits) * 1e-6), ""});
  return table.text();
}

// The one line people look for.
std::string search_line(const EngineProfile& profile) {
  std::string line = "Dijkstra (free search and locked search) in the " +
                     name_of(engine_names, profile.engine) + " engine:";
  const char* separator = " ";
  for (const auto& [name, phase] : phase_names) {
    const PhaseProfile p = profile_of(profile.run.relaxation, phase);
    if (p.steps == 0) continue;
    line += fmt::format("{}{:.1f} % of the {} phase", separator, 100 * p.search_share(), name);
    separator = ", ";
  }
  return line;
}

void print_profiles(const PreparedInput& start, const std::vector<EngineProfile>& profiles) {
  const Relaxation& relaxation = profiles.front().run.relaxation;
  const StepCounts steps = count_steps(relaxation);
  print_heading(start);
  for (const EngineProfile& profile : profiles) fmt::print("{}\n", table_of(profile));
  for (const EngineProfile& profile : profiles) {
    if (!profile.run.relaxation.steps.empty()) fmt::print("{}\n", search_line(profile));
  }
  fmt::print("{}, {} of {}; step by step in the files of --output\n",
             counted(steps.greedy, "greedy step", "greedy steps"),
             counted(steps.macro, "macrostep", "macrosteps"),
             counted(steps.micro, "microstep", "microsteps"));
}

Json json_of(const EngineProfile& profile, const ProfileArguments& a) {
  const Relaxation& relaxation = profile.run.relaxation;
  return {{"engine", name_of(engine_names, profile.engine)},
          {"frontier", frontier_part(profile.engine, a.engine.frontier)},
          {"backend", backend_part(profile.engine, a.threads.backend)},
          {"threads", profile.threads},
          {"seconds", profile.run.seconds},
          {"fingerprint", fingerprint_text(relaxation.fingerprint)},
          {"end", name_of(stop_reason_names, relaxation.stop_reason)},
          {"phases", phase_rows(relaxation)},
          {"steps", step_rows(relaxation)}};
}

// What --json prints, written, too.
Json write_profiles(const ProfileArguments& arguments, const PreparedInput& start,
                    const std::vector<EngineProfile>& profiles) {
  Json result = begin_result("profile", start.input);
  result["options"] = options_part(
      arguments.start,
      relaxation_options(arguments.start.seeds, arguments.start.seed_file, arguments.relaxation),
      start.seeds.size());
  result["interrupted"] = interrupted();
  result["graph"] = graph_part(start.mesh_graph.graph, start.components);
  result["seed_fit"] = seed_fit_part(start.seed_fit);
  result["profiles"] = Json::array();
  Json rows = Json::array();
  for (const EngineProfile& profile : profiles) {
    result["profiles"].push_back(json_of(profile, arguments));
    for (Json& step : result["profiles"].back()["steps"]) {
      rows.push_back({{"engine", name_of(engine_names, profile.engine)}});
      rows.back().update(step);
    }
  }
  save_result(arguments.output, "profile", rows, result);
  return result;
}

std::vector<EngineProfile> profile_engines(const ProfileArguments& arguments,
                                           const PreparedInput& start, Scheduler& scheduler,
                                           ProgressLine& progress) {
  std::vector<EngineProfile> profiles;
  for (const EngineKind engine : arguments.engines) {
    progress.part(name_of(engine_names, engine) + ":");
    const auto runtime = make_runtime(engine, arguments.engine.frontier, scheduler);
    MeasuredRun measured = measure_run(
        start.mesh_graph.graph, start.seeds,
        relaxation_options(arguments.start.seeds, arguments.start.seed_file, arguments.relaxation),
        watcher(progress, start.seeds.size()), *runtime);
    const std::size_t threads = engine == EngineKind::reference ? 1 : scheduler.threads();
    profiles.push_back({engine, threads, std::move(measured)});
    if (interrupted()) break;
  }
  return profiles;
}

void run_profile(ProfileArguments& arguments, const Console& console) {
  drop_repeats(arguments.engines);
  check_seeds(arguments.start.seeds, arguments.start.seed_file);
  check_same_course(arguments.relaxation);
  ProgressLine progress(console);
  Scheduler scheduler = make_scheduler(arguments.threads);
  Threads threads(scheduler);
  const PreparedInput start = prepare(arguments.start, {}, threads, progress);
  catch_interrupts();  // before the folder appears, which tells others that it is done
  const MadeFolders folders = prepare_output(arguments.output, "profile", arguments.start);
  const auto profiles = profile_engines(arguments, start, scheduler, progress);
  progress.clear();
  const Json result = write_profiles(arguments, start, profiles);
  print_profiles(start, profiles);
  finish_experiment(arguments.output, "profile", result, console);
  if (interrupted()) throw InterruptedExit{};
  if (profiles.front().run.relaxation.fingerprint != profiles.back().run.relaxation.fingerprint) {
    throw std::runtime_error(
        "the engines gave different results: geolloyd verify tells where they part");
  }
}

}  // namespace

void add_profile_command(CLI::App& program, Console& console) {
  CLI::App* command = program.add_subcommand(
      "profile", "Show where the time goes, by phase and kernel, in both engines");
  const auto a = std::make_shared<ProfileArguments>();
  add_mesh_argument(*command, a->start.mesh);
  add_output_options(*command, a->output, "profile", console);
  add_choice_list(*command, "--engines", a->engines, engine_names, "Engines, separated by commas");
  add_seed_options(*command, a->start.seeds, a->start.seed_file);
  add_graph_options(*command, a->start.graph);
  add_relaxation_options(*command, a->relaxation);
  add_frontier_option(*command, a->engine);
  add_thread_options(*command, a->threads);
  add_reading_options(*command, a->start.reading);
  command->footer(
      "Kernels of the parallel engine run side by side. The time of a step is divided among\n"
      "kernels by their shares in the time of all threads.");
  command->callback([a, &console] { run_profile(*a, console); });
}

}  // namespace geolloyd
