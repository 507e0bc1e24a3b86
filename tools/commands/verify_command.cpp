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

struct VerifyArguments {
  StartArguments start;
  RelaxationArguments relaxation;
  EngineArguments engine;
  ThreadArguments threads;
};

void print_agreement(const Start& start, const Relaxation& relaxation, const PairedEngine& pair,
                     const Scheduler& scheduler) {
  const StepCounts steps = count_steps(relaxation);
  fmt::print("{}: {} graph, {}, {}\n", start.input.file.string(),
             name_of(graph_kind_names, start.mesh_graph.kind),
             counted(start.mesh_graph.graph.node_count(), "node", "nodes"),
             counted(relaxation.seeds.size(), "seed", "seeds"));
  fmt::print("  {:<12}in every node of {}, {} of {}\n", "identical",
             counted(steps.greedy, "greedy step", "greedy steps"),
             counted(steps.macro, "macrostep", "macrosteps"),
             counted(steps.micro, "microstep", "microsteps"));
  fmt::print("  {:<12}{}\n", "fingerprint", fingerprint_text(relaxation.fingerprint));
  fmt::print("  {:<12}reference {:.3f} s, parallel {:.3f} s with {} of {}: {:.1f} times as fast\n",
             "time", pair.expected_seconds(), pair.tested_seconds(),
             counted(scheduler.threads(), "thread", "threads"),
             name_of(backend_names, scheduler.backend()),
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

void run_verify(const VerifyArguments& a) {
  check_seeds(a.start.seeds);
  ProgressLine progress;
  Scheduler scheduler = make_scheduler(a.threads);
  const Start start = prepare(a.start, {}, scheduler, progress);
  catch_interrupts();
  const Graph& graph = start.mesh_graph.graph;
  const auto reference = make_reference_engine(graph);
  const auto parallel = make_parallel_engine(scheduler, graph, a.engine.frontier);
  PairedEngine pair(*reference, *parallel);
  Relaxation relaxation;
  try {
    relaxation = relax(graph, pair, start.seeds, relaxation_options(a.start.seeds, a.relaxation),
                       [&](const Progress& p) {
                         progress.show(p, start.seeds.size());
                         return !interrupted();
                       });
  } catch (const Disagreement& difference) {
    throw std::runtime_error(describe(difference, start.mesh_graph));
  }
  progress.clear();
  print_agreement(start, relaxation, pair, scheduler);
  if (relaxation.stop_reason == StopReason::interrupted) throw InterruptedExit{};
}

}  // namespace

void add_verify_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "verify", "Run both engines side by side and compare them at every step, node by node");
  const auto arguments = std::make_shared<VerifyArguments>();
  add_mesh_argument(*command, arguments->start);
  add_seed_options(*command, arguments->start.seeds);
  add_graph_options(*command, arguments->start.graph);
  add_relaxation_options(*command, arguments->relaxation);
  add_frontier_option(*command, arguments->engine);
  add_thread_options(*command, arguments->threads);
  command->footer(
      "If the engines differ, the first step, node and value is named, and the exit status is 1.\n"
      "Times are those of the relaxation alone.");
  command->callback([arguments] { run_verify(*arguments); });
}

}  // namespace geolloyd
