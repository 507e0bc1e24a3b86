#include <fmt/format.h>
#include <CLI/App.hpp>

#include <memory>

#include "core/base/stopwatch.h"
#include "core/lloyd/paired_engine.h"
#include "core/lloyd/reference_engine.h"
#include "parallel/engine/parallel_engine.h"
#include "tools/commands/commands.h"
#include "tools/report/report_parts.h"
#include "tools/run/stages.h"
#include "tools/system/interrupt.h"
#include "tools/words/facts_text.h"
#include "tools/words/names.h"

namespace geolloyd {
namespace {

void print_agreement(const RunRecord& run, const PairedEngine& pair) {
  const StepCounts steps = count_steps(run.relaxation);
  const Graph& graph = run.mesh_graph.graph;
  fmt::print("{}: {} graph, {}, {}\n", run.arguments.mesh.string(), run.arguments.graph,
             counted(graph.node_count(), "node", "nodes"),
             counted(run.relaxation.seeds.size(), "seed", "seeds"));
  fmt::print("  {:<12}in every node of {}, {} of {}\n", "identical",
             counted(steps.greedy, "greedy step", "greedy steps"),
             counted(steps.macro, "macrostep", "macrosteps"),
             counted(steps.micro, "microstep", "microsteps"));
  fmt::print("  {:<12}{}\n", "fingerprint", fingerprint_text(run.relaxation.fingerprint));
  fmt::print("  {:<12}reference {:.3f} s, parallel {:.3f} s with {} of {}: {:.1f} times as fast\n",
             "time", pair.expected_seconds(), pair.tested_seconds(),
             counted(run.threads, "thread", "threads"), run.arguments.backend,
             pair.expected_seconds() / pair.tested_seconds());
}

std::string describe(const Disagreement& difference, const MeshGraph& mesh_graph) {
  std::string text = "the engines differ ";
  text += difference.what();
  if (difference.node != no_id) {
    text += fmt::format(", at node {} (input id {})", difference.node,
                        mesh_graph.input_id[difference.node]);
  }
  return text;
}

void run_verify(const RelaxArguments& arguments) {
  check_arguments(arguments);
  RunRecord run;
  run.arguments = arguments;
  ProgressLine progress;
  Scheduler scheduler = make_scheduler(arguments);
  std::vector<NodeId> seeds = prepare(run, scheduler, progress);
  catch_interrupts();
  const Graph& graph = run.mesh_graph.graph;
  run.threads = scheduler.threads();
  const auto reference = make_reference_engine(graph);
  const auto parallel =
      make_parallel_engine(scheduler, graph, value_of(frontier_names, arguments.frontier));
  PairedEngine pair(*reference, *parallel);
  const std::size_t count = seeds.size();
  try {
    run.relaxation =
        relax(graph, pair, std::move(seeds), relaxation_options(arguments), [&](const Progress& p) {
          progress.show(p, count);
          return !interrupted();
        });
  } catch (const Disagreement& difference) {
    throw std::runtime_error(describe(difference, run.mesh_graph));
  }
  progress.clear();
  print_agreement(run, pair);
  if (run.relaxation.stop_reason == StopReason::interrupted) throw InterruptedExit{};
}

}  // namespace

void add_verify_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "verify", "Relax with both engines side by side and compare everything, node by node");
  const auto arguments = std::make_shared<RelaxArguments>();
  add_mesh_argument(*command, *arguments);
  add_seed_options(*command, *arguments);
  add_graph_options(*command, *arguments);
  add_relaxation_options(*command, *arguments);
  add_thread_options(*command, *arguments);
  command->footer(
      "Exit status 1 where they differ: the first step, node and value is named. The time of\n"
      "the two is that of the relaxation alone.");
  command->callback([arguments] { run_verify(*arguments); });
}

}  // namespace geolloyd
