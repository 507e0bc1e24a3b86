#include <fmt/format.h>
#include <CLI/App.hpp>

#include <memory>

#include "tools/cli/folder_option.h"
#include "tools/commands/commands.h"
#include "tools/experiments/experiment.h"
#include "tools/report/ground_truth_output.h"
#include "tools/run/stages.h"

namespace geolloyd {
namespace {

void run_ground_truth(const RelaxArguments& arguments) {
  check_arguments(arguments);
  RunRecord run;
  run.arguments = arguments;
  run.arguments.ground_truth = true;
  ProgressLine progress;
  Scheduler scheduler = make_scheduler(arguments);
  run.relaxation.seeds = prepare(run, scheduler, progress);
  prepare_ground_truth_output(arguments);
  const std::vector<NodeId>& seeds = run.relaxation.seeds;
  run.threads = scheduler.threads();
  progress.stage("partitioning");
  partition_seeds(run, scheduler);
  find_ground_truth(run, scheduler, progress);
  write_ground_truth(run);
  progress.clear();
  print_heading(run, seeds.size());
  fmt::print("{}", describe(*run.ground_truth));
}

}  // namespace

void add_ground_truth_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "ground-truth", "Compare the regions of seeds with those by Euclidean distance");
  const auto arguments = std::make_shared<RelaxArguments>();
  add_mesh_argument(*command, *arguments);
  folder_name(command->add_option("-o,--output", arguments->output,
                                  "Folder for ground-truth.json, ground-truth-seeds.csv and\n"
                                  "ground-truth-regions.csv"));
  add_seed_options(*command, *arguments);
  add_graph_options(*command, *arguments);
  add_thread_options(*command, *arguments);
  command->footer("Seeds are judged where they are; `relax --ground-truth` judges relaxed ones.");
  command->callback([arguments] { run_ground_truth(*arguments); });
}

}  // namespace geolloyd
