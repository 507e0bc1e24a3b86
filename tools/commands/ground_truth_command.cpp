#include <fmt/format.h>
#include <CLI/App.hpp>

#include <cstdio>
#include <memory>

#include "core/base/stopwatch.h"
#include "tools/cli/folder_option.h"
#include "tools/cli/relax_arguments.h"
#include "tools/cli/summary_options.h"
#include "tools/commands/commands.h"
#include "tools/experiments/experiment.h"
#include "tools/report/ground_truth_output.h"
#include "tools/run/stages.h"
#include "tools/system/interrupt.h"

namespace geolloyd {
namespace {

struct GroundTruthArguments {
  RunRequest start;
  EngineArguments engine;
  ThreadArguments threads;
  std::filesystem::path output;
};

void run_ground_truth(const GroundTruthArguments& a) {
  check_seeds(a.start.seeds, a.start.seed_file);
  ProgressLine progress;
  Scheduler scheduler = make_scheduler(a.threads);
  Threads threads(scheduler, a.engine.frontier);
  RunWork work;
  work.has_ground_truth = true;
  const PreparedInput start = prepare(a.start, work, threads, progress);
  catch_interrupts();  // before the folder appears
  prepare_ground_truth_output(a.output, a.start);
  progress.stage("partitioning");
  JudgedPartition judged;
  judged.threads = scheduler.threads();
  judged.partition = partition_seeds(start.mesh_graph.graph, start.seeds, threads).partition;
  progress.stage("finding the ground truth");
  const Stopwatch watch;
  judged.truth = make_ground_truth(scheduler, start.input.mesh(), start.mesh_graph,
                                   judged.partition, start.seeds);
  judged.seconds = watch.seconds();
  if (interrupted()) {
    progress.clear();
    std::fputs("geolloyd: interrupted\n", stderr);
    throw InterruptedExit{};
  }
  write_ground_truth(a.output, a.start, start, judged);
  progress.clear();
  print_heading(start);
  fmt::print("{}", describe(judged.truth));
}

}  // namespace

void add_ground_truth_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "ground-truth", "Compare the regions of seeds with regions by Euclidean distance");
  const auto arguments = std::make_shared<GroundTruthArguments>();
  add_mesh_argument(*command, arguments->start.mesh);
  folder_name(command->add_option("-o,--output", arguments->output,
                                  "Folder for ground-truth.json, ground-truth-seeds.csv and\n"
                                  "ground-truth-regions.csv"));
  add_json_option(*command);
  add_seed_options(*command, arguments->start.seeds, arguments->start.seed_file);
  add_graph_options(*command, arguments->start.graph);
  add_frontier_option(*command, arguments->engine);
  add_thread_options(*command, arguments->threads);
  command->footer("Seeds are judged as they are; `relax --ground-truth` judges relaxed seeds.");
  command->callback([arguments] { run_ground_truth(*arguments); });
}

}  // namespace geolloyd
