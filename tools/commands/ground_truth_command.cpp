#include <fmt/format.h>
#include <CLI/App.hpp>

#include <cstdio>
#include <memory>

#include "core/base/stopwatch.h"
#include "tools/cli/folder_option.h"
#include "tools/cli/reading_options.h"
#include "tools/cli/relax_arguments.h"
#include "tools/cli/summary_options.h"
#include "tools/commands/commands.h"
#include "tools/report/ground_truth_output.h"
#include "tools/report/heading.h"
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

JudgedPartition judge(const PreparedInput& start, Scheduler& scheduler, Threads& threads,
                      ProgressLine& progress) try {
  scheduler.set_watch(give_up_if_interrupted);
  progress.stage("partitioning");
  JudgedPartition judged;
  judged.threads = scheduler.threads();
  judged.partition = partition_seeds(start.mesh_graph.graph, start.seeds, threads).partition;
  progress.stage("finding the ground truth");
  const Stopwatch watch;
  judged.truth = make_ground_truth(scheduler, start.input.mesh(), start.mesh_graph,
                                   judged.partition, start.seeds);
  judged.seconds = watch.seconds();
  return judged;
} catch (const InterruptedExit&) {
  progress.clear();
  std::fputs("geolloyd: interrupted\n", stderr);
  throw;
}

void run_ground_truth(const GroundTruthArguments& a, const Console& console) {
  check_seeds(a.start.seeds, a.start.seed_file);
  ProgressLine progress(console);
  Scheduler scheduler = make_scheduler(a.threads);
  Threads threads(scheduler, a.engine.frontier);
  RunWork work;
  work.has_ground_truth = true;
  const PreparedInput start = prepare(a.start, work, threads, progress);
  catch_interrupts();  // before the folder appears
  const MadeFolders folders = prepare_ground_truth_output(a.output, a.start);
  const JudgedPartition judged = judge(start, scheduler, threads, progress);
  const std::string report = write_ground_truth(a.output, a.start, start, judged);
  progress.clear();
  if (console.wants_json()) console.print_json(report);
  print_heading(start);
  fmt::print("{}", describe(judged.truth));
}

}  // namespace

void add_ground_truth_command(CLI::App& program, Console& console) {
  CLI::App* command = program.add_subcommand(
      "ground-truth", "Compare the regions of seeds with their Euclidean Voronoi diagram");
  const auto arguments = std::make_shared<GroundTruthArguments>();
  add_mesh_argument(*command, arguments->start.mesh);
  folder_name(command->add_option("-o,--output", arguments->output,
                                  "Folder for ground-truth.json, ground-truth-seeds.csv and\n"
                                  "ground-truth-regions.csv"));
  add_json_option(*command, console);
  add_seed_options(*command, arguments->start.seeds, arguments->start.seed_file);
  add_graph_options(*command, arguments->start.graph);
  add_frontier_option(*command, arguments->engine);
  add_thread_options(*command, arguments->threads);
  add_reading_options(*command, arguments->start.reading);
  command->footer("Seeds are judged as they are; `relax --ground-truth` judges relaxed seeds.");
  command->callback([arguments, &console] { run_ground_truth(*arguments, console); });
}

}  // namespace geolloyd
