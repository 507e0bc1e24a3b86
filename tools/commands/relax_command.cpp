#include <fmt/format.h>
#include <CLI/App.hpp>

#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/errors.h"
#include "tools/cli/folder_option.h"
#include "tools/cli/number_option.h"
#include "tools/commands/commands.h"
#include "tools/render/labels.h"
#include "tools/report/ground_truth_output.h"
#include "tools/report/relax_output.h"
#include "tools/report/report_parts.h"
#include "tools/run/resumable.h"
#include "tools/run/run_record.h"
#include "tools/run/stages.h"
#include "tools/system/interrupt.h"
#include "tools/system/machine.h"
#include "tools/system/progress.h"
#include "tools/words/facts_text.h"

namespace geolloyd {
namespace {

void make_remesh(RunRecord& run, Scheduler& scheduler, Engine& engine) {
  const Stopwatch watch;
  run.remesh = make_remesh({run.input.mesh, run.mesh_graph, run.relaxation.seeds, engine},
                           remesh_options(run.arguments), scheduler);
  run.seconds.remesh = watch.seconds();
}

const char* describe(StopReason end) {
  switch (end) {
    case StopReason::converged:
      return "converged";
    case StopReason::interrupted:
      return "INTERRUPTED, best state so far,";
    case StopReason::limit:
      return "stopped at the limit of macrosteps, best state so far,";
    case StopReason::recurred:
      return "STOPPED, the seeds wander between equally good states; the best state";
  }
  return "";
}

void print_regions(const RunRecord& run) {
  const RegionSpread areas = region_spread(run.regions);
  if (!(areas.largest > 0)) return;  // without area
  fmt::print(
      "  {:<12}areas {:.3g} to {:.3g} of their mean, deviation {:.3g}; isoperimetric ratio "
      "{:.3g}, smallest {:.3g}\n",
      "regions", areas.smallest, areas.largest, areas.deviation, run.remesh.roundness.mean,
      run.remesh.roundness.min);
}

void print_remesh(const Remesh& remesh) {
  fmt::print("  {:<12}{}, {}, Euler characteristic {}, {}\n", "remesh",
             counted(remesh.mesh.vertex_count(), "vertex", "vertices"),
             counted(remesh.mesh.triangle_count(), "triangle", "triangles"),
             remesh.topology.total().euler_characteristic, describe(remesh.topology));
  if (remesh.seeds_added > 0) {
    fmt::print("  {:<12}{} added where regions did not meet as they should\n", "",
               counted(remesh.seeds_added, "seed", "seeds"));
  }
  if (remesh.flipped > 0) {
    fmt::print("  {:<12}{} from the surface\n", "",
               counted(remesh.flipped, "triangle faces away", "triangles face away"));
  }
  if (!remesh.flaw.empty()) {
    fmt::print("  {:<12}NO MANIFOLD of the input's topology: {}\n", "", remesh.flaw);
  }
}

void print_summary(const RunRecord& run) {
  const Relaxation& result = run.relaxation;
  const StepCounts steps = count_steps(result);
  const Graph& graph = run.mesh_graph.graph;
  const double hexagonal = hexagonal_energy(run);
  const StageSeconds& s = run.seconds;
  fmt::print("{}\n{}", run.arguments.mesh.string(), describe(run.input, run.facts));
  fmt::print("  {:<12}{}: {}, {}, {}\n", "graph", run.arguments.graph,
             counted(graph.node_count(), "node", "nodes"),
             counted(graph.arc_count(), "arc", "arcs"),
             counted(run.components, "component", "components"));
  fmt::print(
      "  {:<12}{} from {}\n", "seeds", grouped(run.regions.size()),
      run.arguments.seeds_file.empty() ? run.arguments.init : run.arguments.seeds_file.string());
  if (run.resumed) {
    fmt::print("  {:<12}after {}, {:.2f} s\n", "resumed",
               counted(run.resumed->steps, "step", "steps"), run.resumed->seconds);
  }
  fmt::print("  {:<12}{} after {}, {} of {}\n", "relaxation", describe(result.stop_reason),
             counted(steps.greedy, "greedy step", "greedy steps"),
             counted(steps.macro, "macrostep", "macrosteps"),
             counted(steps.micro, "microstep", "microsteps"));
  fmt::print("  {:<12}{:.8g} -> {:.8g}{}\n", "energy", initial_energy(result), result.energy,
             hexagonal > 0
                 ? fmt::format(", {:.5g} of a regular hexagonal tiling", result.energy / hexagonal)
                 : "");
  if (run.ground_truth) fmt::print("{}", describe(*run.ground_truth));
  print_regions(run);
  print_remesh(run.remesh);
  fmt::print("  {:<12}{}\n", "fingerprint", fingerprint_text(result.fingerprint));
  fmt::print("  {:<12}{:.2f} s: load {:.2f}, graph {:.2f}, seeds {:.2f}, relaxation {:.2f}, ",
             "time", s.total, s.load, s.graph, s.seeds, s.relax);
  if (run.ground_truth) fmt::print("ground truth {:.2f}, ", s.ground_truth);
  fmt::print("remesh {:.2f}, write {:.2f}; {:.0f} MB, {}\n", s.remesh, s.write,
             static_cast<double>(run.peak_memory_bytes) * 1e-6,
             counted(run.threads, "thread", "threads"));
  fmt::print("  {:<12}{}/: tessellation.ply seeds.csv regions.csv remesh.ply report.json\n",
             "written", run.arguments.output.string());
  if (!run.arguments.picture.empty()) {
    fmt::print("  {:<12}{}\n", "", run.arguments.picture.string());
  }
  if (!run.arguments.frames.empty()) {
    fmt::print("  {:<12}{}/: {}\n", "", run.arguments.frames.string(),
               counted(result.steps.size(), "frame", "frames"));
  }
}

// A region of fewer nodes has hardly a neighbourhood for its seed to move in.
void warn_of_few_nodes(const RunRecord& run, std::size_t seeds, ProgressLine& progress) {
  constexpr std::size_t enough = 10;
  const std::size_t nodes = run.mesh_graph.graph.node_count();
  if (nodes >= enough * seeds) return;
  progress.clear();
  fmt::print(stderr,
             "{}: {} for {}: with fewer than {} a seed the remesh will be poor: subdivide the "
             "mesh, or use fewer seeds\n",
             run.arguments.mesh.string(), counted(nodes, "node", "nodes"),
             counted(seeds, "seed", "seeds"), enough);
}

void check_relax(const RelaxArguments& arguments) {
  check_arguments(arguments);
  const std::filesystem::path checkpoint = checkpoint_path(arguments.output);
  std::error_code error;
  const bool is_there = std::filesystem::exists(checkpoint, error);
  if (error) throw IoError(checkpoint.string() + ": cannot open: " + error.message());
  if (arguments.resume && !is_there) {
    throw InvalidInput(checkpoint.string() +
                       ": no such checkpoint to go on from: start without --resume");
  }
  if (!arguments.resume && is_there) {
    throw InvalidInput(
        checkpoint.string() +
        ": is of an unfinished run: go on with --resume, or remove it to begin anew");
  }
}

void run_relax(const RelaxArguments& arguments) {
  check_relax(arguments);
  const Stopwatch total;
  RunRecord run;
  run.arguments = arguments;
  ProgressLine progress;
  Scheduler scheduler = make_scheduler(arguments);
  std::vector<NodeId> seeds = prepare(run, scheduler, progress);
  warn_of_few_nodes(run, seeds.size(), progress);
  ResumableRelaxation relaxation(run, std::move(seeds));
  catch_interrupts();  // before the folder appears, which tells others that it is done
  prepare_output(arguments);
  const auto engine = relaxation.relax(scheduler, progress);
  if (arguments.ground_truth) find_ground_truth(run, scheduler, progress);
  progress.stage("making the remesh");
  make_remesh(run, scheduler, *engine);

  run.interrupted = interrupted();  // from here on one changes nothing
  const bool is_resumable = run.interrupted && relaxation.save(progress);

  progress.stage("writing " + arguments.output.string());
  const Stopwatch writing;
  run.regions = summarise_regions(run.mesh_graph.graph, run.relaxation.partition,
                                  run.relaxation.seeds, run.relaxation.region_score);
  run.labels = label_input_ids(run.mesh_graph, run.relaxation.partition, run.regions.size());
  FileGroup files = open_results(arguments);
  write_results(run, files, scheduler);
  run.seconds.write = writing.seconds();
  run.seconds.total = total.seconds();
  run.peak_memory_bytes = peak_memory_bytes();
  write_report(run, files);
  if (!run.interrupted) relaxation.forget();
  if (!arguments.picture.empty()) {  // whatever happens to it, the results are there
    progress.stage("drawing " + arguments.picture.string());
    write_picture(run, scheduler);
  }
  progress.clear();
  print_summary(run);
  if (is_resumable) fmt::print("  {:<12}the same command and --resume\n", "to go on");
  if (run.interrupted) throw InterruptedExit{};
}

}  // namespace

void add_relax_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "relax", "Tessellate a mesh: move seeds to the centroids of their regions");
  const auto arguments = std::make_shared<RelaxArguments>();
  add_mesh_argument(*command, *arguments);
  folder_name(
      command->add_option("-o,--output", arguments->output,
                          "Folder for tessellation.ply, seeds.csv, regions.csv, remesh.ply,\n"
                          "report.json"))
      ->required();
  command->add_option("--picture", arguments->picture, "PNG file to draw the result into")
      ->type_name("FILE");
  folder_name(command->add_option("--frames", arguments->frames,
                                  "Folder for a picture of the start of each step, NNN-PHASE.png"));
  command->add_flag("--ground-truth", arguments->ground_truth,
                    "Judge the result by the regions of Euclidean distance");
  time_in_seconds(
      command->add_option("--checkpoint", arguments->checkpoint_seconds,
                          "Write a checkpoint every so many seconds (0: after each step), from\n"
                          "which --resume goes on; it goes when the work is done"))
      ->capture_default_str();
  command->add_flag("--resume", arguments->resume,
                    "Go on from the checkpoint in the folder, with the options of before");
  add_seed_options(*command, *arguments);
  add_graph_options(*command, *arguments);
  add_relaxation_options(*command, *arguments);
  add_remesh_options(*command, *arguments);
  add_engine_option(*command, *arguments);
  add_thread_options(*command, *arguments);
  add_picture_options(*command, *arguments);
  command->footer(
      "Ctrl-C ends the work and writes the best result so far. To go on from there, also\n"
      "after a crash: the same command and --resume");
  command->callback([arguments] { run_relax(*arguments); });
}

}  // namespace geolloyd
