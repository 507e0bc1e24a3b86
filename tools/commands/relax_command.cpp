#include <fmt/format.h>
#include <CLI/App.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include "core/start/first_seeds.h"
#include "geolloyd/errors.h"
#include "tools/cli/choice_option.h"
#include "tools/cli/folder_option.h"
#include "tools/cli/number_option.h"
#include "tools/cli/reading_options.h"
#include "tools/cli/relax_arguments.h"
#include "tools/cli/repair_arguments.h"
#include "tools/cli/summary_options.h"
#include "tools/commands/commands.h"
#include "tools/evaluation/attribute_transfer.h"
#include "tools/files/folder_lock.h"
#include "tools/report/dual_output.h"
#include "tools/report/ground_truth_output.h"
#include "tools/report/relax_output.h"
#include "tools/report/report.h"
#include "tools/report/report_parts.h"
#include "tools/report/vtp_output.h"
#include "tools/run/frames.h"
#include "tools/run/result.h"
#include "tools/run/resumable.h"
#include "tools/run/stages.h"
#include "tools/system/interrupt.h"
#include "tools/system/machine.h"
#include "tools/system/progress.h"
#include "tools/view/page.h"
#include "tools/view/page_contents.h"
#include "tools/words/facts_text.h"

namespace geolloyd {
namespace {

struct RelaxArguments {
  RunRequest start;
  RepairArguments repair;
  RelaxationArguments relaxation;
  EngineArguments engine;
  ThreadArguments threads;
  DualRequest dual;
  PictureLook look;
  RelaxTargets targets;
  bool ground_truth = false;
  double checkpoint_seconds = 60;  // between two of them
  bool resume = false;

  // The report tells of it, too.
  [[nodiscard]] bool makes_dual() const {
    return targets.writes(RelaxOutput::dual) || targets.writes(RelaxOutput::report);
  }
  [[nodiscard]] RelaxationOptions options() const {
    return relaxation_options(start.seeds, start.seed_file, relaxation);
  }
};

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

void print_regions(const Result& result) {
  const RegionSpread areas = region_spread(result.regions);
  if (!(areas.largest > 0)) return;  // without area
  fmt::print("  {:<12}areas {:.3g} to {:.3g} of their mean, deviation {:.3g}{}\n", "regions",
             areas.smallest, areas.largest, areas.deviation,
             result.dual ? fmt::format("; isoperimetric ratio {:.3g}, smallest {:.3g}",
                                       result.dual->roundness.mean, result.dual->roundness.min)
                         : "");
}

std::string describe_seeds(const RunRequest& request, const PreparedRun& run) {
  if (!request.seed_file.path.empty()) return request.seed_file.path.string();
  std::string name = name_of(seed_init_names, request.seeds.init);
  if (request.seeds.init != SeedInit::automatic) return name;
  const SeedInit suited = suited_init(run.mesh_graph.graph.node_count(), run.seeds.size());
  return fmt::format("{} ({})", name, name_of(seed_init_names, suited));
}

void print_start(const RunRequest& request, const PreparedInput& start) {
  const Graph& graph = start.mesh_graph.graph;
  fmt::print("{}\n{}", start.input.file.string(), describe(start.input.loaded, start.input.facts));
  if (start.input.repairs) fmt::print("{}", describe(*start.input.repairs));
  fmt::print("  {:<12}{}: {}, {}, {}\n", "graph", name_of(graph_kind_names, start.mesh_graph.kind),
             counted(graph.node_count(), "node", "nodes"),
             counted(graph.arc_count(), "arc", "arcs"),
             counted(start.components, "component", "components"));
  fmt::print("  {:<12}{} from {}\n", "seeds", grouped(start.seeds.size()),
             describe_seeds(request, start));
  if (start.seed_fit) fmt::print("{}", describe(*start.seed_fit, start.input.facts));
}

void print_relaxation(const Result& result, double hexagonal) {
  const Relaxation& relaxation = result.relaxation;
  const StepCounts steps = count_steps(relaxation);
  if (result.resumed) {
    fmt::print("  {:<12}after {}, {:.2f} s\n", "resumed",
               counted(result.resumed->steps, "step", "steps"), result.resumed->seconds);
  }
  fmt::print("  {:<12}{} after {}, {} of {}\n", "relaxation", describe(relaxation.stop_reason),
             counted(steps.greedy, "greedy step", "greedy steps"),
             counted(steps.macro, "macrostep", "macrosteps"),
             counted(steps.micro, "microstep", "microsteps"));
  if (steps.improvement > 0) {
    fmt::print("  {:<12}{}\n", "improvement", counted(steps.improvement, "round", "rounds"));
  }
  fmt::print(
      "  {:<12}{:.8g} -> {:.8g}{}\n", "energy", initial_energy(relaxation), relaxation.energy,
      hexagonal > 0
          ? fmt::format(", {:.5g} of a regular hexagonal tiling", relaxation.energy / hexagonal)
          : "");
}

void print_cost(const PreparedInput& start, const Result& result, const Cost& cost) {
  fmt::print("  {:<12}{:.2f} s: load {:.2f}, graph {:.2f}, seeds {:.2f}, relaxation {:.2f}, ",
             "time", cost.total_seconds, start.load_seconds, start.seconds.graph,
             start.seconds.seeds, cost.relax_seconds);
  if (result.ground_truth) fmt::print("ground truth {:.2f}, ", cost.ground_truth_seconds);
  fmt::print("dual {:.2f}, write {:.2f}; {:.0f} MB, {}\n", cost.dual_seconds, cost.write_seconds,
             static_cast<double>(cost.peak_memory_bytes) * 1e-6,
             counted(result.threads, "thread", "threads"));
}

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += " " + name;
  return list;
}

void print_files(const RelaxTargets& targets, const std::vector<std::string>& removed,
                 std::size_t frames) {
  const std::string folder = targets.folder.string();
  fmt::print("  {:<12}{}/:{}\n", "written", folder, listed(names_of_results(targets)));
  if (!removed.empty()) {
    fmt::print("  {:<12}{}/:{}, of an earlier run\n", "removed", folder, listed(removed));
  }
  for (const std::filesystem::path& file : {targets.vtp_file, targets.picture_file}) {
    if (!file.empty()) fmt::print("  {:<12}{}\n", "", file.string());
  }
  if (!targets.frames.empty()) {
    fmt::print("  {:<12}{}/: {}\n", "", targets.frames.string(),
               counted(frames, "frame", "frames"));
  }
}

void print_summary(const RelaxArguments& arguments, const PreparedInput& start,
                   const Result& result, const Cost& cost) {
  print_start(arguments.start, start);
  print_relaxation(result, hexagonal_energy(result.regions, start.input.facts));
  if (result.ground_truth) fmt::print("{}", describe(*result.ground_truth));
  print_regions(result);
  if (result.dual) {
    fmt::print("{}{}{}", describe(*result.dual), describe(result.dual->quads),
               describe(result.dual->properties));
  }
  fmt::print("  {:<12}{}\n", "fingerprint", fingerprint_text(result.relaxation.fingerprint));
  print_cost(start, result, cost);
}

// A region of fewer nodes has hardly a neighbourhood for its seed to move in.
void warn_of_few_nodes(const PreparedInput& start, ProgressLine& progress) {
  constexpr std::size_t enough = 10;
  const std::size_t nodes = start.mesh_graph.graph.node_count();
  const std::size_t seeds = start.seeds.size();
  if (nodes >= enough * seeds) return;
  progress.clear();
  fmt::print(stderr,
             "{}: {} for {}: with fewer than {} a seed the dual will be poor: subdivide the "
             "mesh, or use fewer seeds\n",
             start.input.file.string(), counted(nodes, "node", "nodes"),
             counted(seeds, "seed", "seeds"), enough);
}

void check_checkpoint(const RelaxArguments& arguments) {
  const std::filesystem::path checkpoint = checkpoint_path(arguments.targets.folder);
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

RunWork work_of(const RelaxArguments& arguments) {
  RunWork work;
  work.has_dual = arguments.makes_dual();
  work.has_ground_truth = arguments.ground_truth ||
                          (work.has_dual && arguments.dual.vertices == DualVertices::centroids);
  if (!arguments.targets.picture_file.empty() || !arguments.targets.frames.empty()) {
    work.picture = arguments.look;
  }
  return work;
}

// All that follows the relaxation.
Result judge(const RelaxArguments& arguments, const PreparedInput& start, EndedRelaxation& ended,
             Cost& cost, Executor& executor, ProgressLine& progress) {
  Result result;
  result.relaxation = std::move(ended.relaxation);
  result.threads = arguments.engine.kind == EngineKind::reference ? 1 : executor.threads();
  const Relaxation& relaxation = result.relaxation;
  if (arguments.ground_truth && !interrupted()) {
    progress.stage("finding the ground truth");
    const Stopwatch watch;
    result.ground_truth = make_ground_truth(executor, start.input.mesh(), start.mesh_graph,
                                            relaxation.partition, relaxation.seeds);
    cost.ground_truth_seconds = watch.seconds();
  }
  if (!arguments.makes_dual()) return result;
  progress.stage("making the dual");
  const Stopwatch watch;
  result.dual = make_whole_dual(start, relaxation.seeds, relaxation.partition, *ended.engine,
                                arguments.dual, executor);
  cost.dual_seconds = watch.seconds();
  return result;
}

RelaxFacts facts_of(const RelaxArguments& arguments) {
  RunRequest request = arguments.start;
  request.repair = arguments.repair.wanted();
  return {request,
          arguments.options(),
          arguments.engine.kind,
          arguments.engine.frontier,
          arguments.threads.backend,
          arguments.dual};
}

// Whose numbers a repair would change; empty: none is given.
std::string option_that_names_vertices(const RunRequest& request) {
  if (!request.seed_file.path.empty() && request.seed_file.by == SeedsBy::id) {
    return "--seeds-file";
  }
  return request.graph.field_file().empty() ? "" : "--vfield";
}

// Draws what --frames asks for; keeps the seeds for the page.
class CourseWatch {
 public:
  /// All must live on.
  CourseWatch(const RelaxArguments& arguments, const PreparedInput& start, Runtime& runtime)
      : keeps_course_(!arguments.targets.page_file.empty()) {
    if (arguments.targets.frames.empty()) return;
    frames_.emplace(arguments.targets.frames, arguments.look, start, runtime);
  }

  void operator()(const StepStart& step) {
    if (frames_) frames_->draw(step);
    if (keeps_course_) course_.push_back(step.seeds);
  }

  /// The seeds at the start of each step that this run took; for a page, else none.
  [[nodiscard]] std::span<const std::vector<NodeId>> course() const { return course_; }

 private:
  bool keeps_course_;
  std::optional<Frames> frames_;
  std::vector<std::vector<NodeId>> course_;
};

void run_relax(const RelaxArguments& arguments, const Console& console) {
  const RelaxTargets& targets = arguments.targets;
  if (!targets.page_file.empty()) check_viewer();
  check_seeds(arguments.start.seeds, arguments.start.seed_file);
  check_repair(arguments.repair, option_that_names_vertices(arguments.start));
  if (!targets.frames.empty() && arguments.relaxation.improvement.rounds > 0) {
    throw InvalidInput("--frames and --improve exclude each other: a round is no single picture");
  }
  lock_folder(targets.folder);  // where it is there: before the mesh is read
  check_checkpoint(arguments);
  const Stopwatch total;
  ProgressLine progress(console);
  Scheduler scheduler = make_scheduler(arguments.threads);
  Threads threads(scheduler, arguments.engine.frontier);
  const auto chosen = make_runtime(arguments.engine.kind, arguments.engine.frontier, scheduler);
  const RelaxFacts facts = facts_of(arguments);
  RunRequest wanted = facts.request;
  wanted.has_properties =
      wanted.has_properties && (arguments.makes_dual() || !targets.vtp_file.empty() ||
                                targets.writes(RelaxOutput::tessellation));
  const PreparedInput start = prepare(wanted, work_of(arguments), threads, progress);
  warn_of_few_nodes(start, progress);
  ResumableRelaxation relaxation(start, facts.options,
                                 {targets.folder, arguments.checkpoint_seconds, arguments.resume});
  catch_interrupts();  // before the folder appears, which tells others that it is done
  const MadeFolders folders = prepare_output(targets, wanted.files(), arguments.resume);
  check_checkpoint(arguments);  // another run may have made the folder meanwhile
  CourseWatch watch(arguments, start, threads);
  EndedRelaxation ended = relaxation.relax(*chosen, progress, std::ref(watch));
  Cost cost;
  cost.relax_seconds = ended.seconds;
  Result result = judge(arguments, start, ended, cost, scheduler, progress);
  ended.engine.reset();
  result.resumed = relaxation.resumed();

  result.interrupted = interrupted();  // from here on one changes nothing
  const bool is_resumable = result.interrupted && relaxation.save(progress);

  progress.stage("writing " + targets.folder.string());
  const Stopwatch writing;
  result.regions = summarise_regions(start.mesh_graph.graph, result.relaxation.partition,
                                     result.relaxation.seeds, result.relaxation.region_score);
  ResultFiles files(targets);
  write_results(start, result, files, scheduler);
  cost.write_seconds = writing.seconds();
  cost.total_seconds = total.seconds();
  cost.peak_memory_bytes = peak_memory_bytes();
  if (FileWriter* const report = files.find(RelaxOutput::report)) {
    report->text(report_text(facts, start, result, cost));
  }
  const std::vector<std::string> removed = files.commit();
  if (!result.interrupted) relaxation.forget();
  // Whatever happens to the other files, the results are there.
  if (!targets.vtp_file.empty()) {
    progress.stage("writing " + targets.vtp_file.string());
    write_vtp(targets.vtp_file, start, result.relaxation.partition);
  }
  if (!targets.picture_file.empty()) {
    progress.stage("drawing " + targets.picture_file.string());
    write_picture(targets.picture_file, arguments.look, start, result.relaxation, scheduler);
  }
  std::string page;
  if (!targets.page_file.empty()) {
    progress.stage("writing " + targets.page_file.string());
    page = write_page(targets.page_file,
                      relax_contents(facts.request.graph, start, result, watch.course(), threads));
  }
  progress.clear();
  if (console.wants_json()) console.print_json(report_text(facts, start, result, cost));
  print_summary(arguments, start, result, cost);
  print_files(targets, removed, result.relaxation.steps.size());
  fmt::print("{}", page);
  if (is_resumable) fmt::print("  {:<12}the same command and --resume\n", "to go on");
  if (result.interrupted) throw InterruptedExit{};
}

}  // namespace

void add_relax_command(CLI::App& program, Console& console) {
  CLI::App* command = program.add_subcommand(
      "relax", "Tessellate a mesh: seeds move to the centroids of their regions");
  const auto arguments = std::make_shared<RelaxArguments>();
  arguments->start.has_properties = true;
  add_mesh_argument(*command, arguments->start.mesh);
  add_json_option(*command, console);
  folder_name(command->add_option("-o,--output", arguments->targets.folder,
                                  "Folder for tessellation.ply, seeds.csv, regions.csv, dual.ply,\n"
                                  "report.json"))
      ->required();
  add_choice_list(*command, "--only", arguments->targets.only, relax_output_names,
                  "Write only these of them, separated by commas, and leave out what\n"
                  "only the others need. Those of an earlier run are removed");
  command
      ->add_option("--vtp", arguments->targets.vtp_file,
                   "VTP file, for ParaView and VTK: the mesh with region and distance to\n"
                   "the seed as arrays")
      ->type_name("FILE");
  command
      ->add_option("--picture", arguments->targets.picture_file,
                   "PNG file for a picture of the result")
      ->type_name("FILE");
  folder_name(command->add_option("--frames", arguments->targets.frames,
                                  "Folder for a picture of each step's start, NNN-PHASE.png"));
  command
      ->add_option("--page", arguments->targets.page_file,
                   "HTML file that shows the result and its course in a browser")
      ->type_name("FILE");
  command->add_flag("--ground-truth", arguments->ground_truth,
                    "Compare the result with the Euclidean Voronoi diagram of its seeds");
  time_in_seconds(
      command->add_option("--checkpoint", arguments->checkpoint_seconds,
                          "Seconds between checkpoints, from which --resume goes on (0: a\n"
                          "checkpoint after each step)"))
      ->capture_default_str();
  command->add_flag("--resume", arguments->resume,
                    "Go on from the checkpoint in the folder; give the same options");
  add_repair_options(*command, arguments->repair);
  add_seed_options(*command, arguments->start.seeds, arguments->start.seed_file);
  add_graph_options(*command, arguments->start.graph);
  add_relaxation_options(*command, arguments->relaxation);
  add_dual_options(*command, arguments->dual.manifold, arguments->dual.vertices,
                   arguments->dual.quads);
  add_drop_option(*command, arguments->start.has_properties);
  add_engine_option(*command, arguments->engine.kind);
  add_frontier_option(*command, arguments->engine);
  add_thread_options(*command, arguments->threads);
  add_reading_options(*command, arguments->start.reading);
  add_picture_options(*command, arguments->look);
  command->footer(
      "Ctrl-C ends the work and writes the best result so far. The same command with --resume\n"
      "goes on from there, also after a crash.");
  command->callback([arguments, &console] { run_relax(*arguments, console); });
}

}  // namespace geolloyd
