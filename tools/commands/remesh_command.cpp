#include <fmt/format.h>
#include <CLI/App.hpp>

#include <memory>
#include <optional>

#include "core/base/stopwatch.h"
#include "tools/cli/surface_remesh_arguments.h"
#include "tools/commands/commands.h"
#include "tools/report/surface_remesh_output.h"
#include "tools/run/stages.h"
#include "tools/run/surface_remesh.h"
#include "tools/system/interrupt.h"
#include "tools/system/machine.h"
#include "tools/system/progress.h"

namespace geolloyd {
namespace {

void run_remesh(const SurfaceRemeshArguments& arguments) {
  check_remesh_targets(arguments);
  const Stopwatch total;
  ProgressLine progress;
  Scheduler scheduler = make_scheduler(arguments.threads);
  const LoadedInput loaded = load_surface(arguments.mesh, scheduler, progress);
  SurfaceRemeshResult result;
  result.memory_estimate = check_remesh_memory(
      loaded, arguments.vertices,
      arguments.picture_file.empty() ? std::nullopt : std::optional(arguments.picture), scheduler);
  result.threads = arguments.engine == EngineKind::reference ? 1 : scheduler.threads();
  catch_interrupts();
  result.made = time_remesh(loaded, arguments.vertices,
                            make_surface_engines(arguments.engine, scheduler), scheduler, progress);
  const SurfaceRemesh& remesh = result.made.remesh;

  progress.stage("measuring the remesh");
  const Stopwatch judging;
  result.figures = judge_remesh(loaded, remesh.mesh, scheduler);
  result.judge_seconds = judging.seconds();

  progress.stage("writing " + arguments.output.string());
  const Stopwatch writing;
  FileGroup files = open_remesh_files(arguments);
  write_remesh(arguments, remesh, files);
  result.write_seconds = writing.seconds();
  result.total_seconds = total.seconds();
  result.peak_memory_bytes = peak_memory_bytes();
  write_remesh_report(arguments, loaded, result, files);
  if (!arguments.picture_file.empty()) {  // whatever happens to it, the results are there
    progress.stage("drawing " + arguments.picture_file.string());
    write_remesh_picture(arguments, remesh.mesh, scheduler);
  }
  progress.clear();
  fmt::print("{}", describe(arguments, loaded, result));
  if (remesh.interrupted) throw InterruptedExit{};
}

}  // namespace

void add_remesh_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "remesh", "Remesh a mesh as regularly as can be: vertices move freely over its surface");
  const auto a = std::make_shared<SurfaceRemeshArguments>();
  command->add_option("MESH", a->mesh, "PLY, OBJ, OFF or STL file")->type_name("")->required();
  add_vertices_option(*command, a->vertices,
                      "Number of vertices; there are more only where the topology needs\n"
                      "them")
      ->required();
  command->add_option("-o,--output", a->output, "PLY, OBJ, OFF or STL file for the remesh")
      ->type_name("FILE")
      ->required();
  command->add_option("--report", a->report_file, "JSON file for all figures")->type_name("FILE");
  command
      ->add_option("--map", a->map_file,
                   "CSV file that tells where on the input each vertex is: a\n"
                   "triangle, and the weights of its corners")
      ->type_name("FILE");
  command->add_option("--picture", a->picture_file, "PNG file for a picture of the remesh")
      ->type_name("FILE");
  add_engine_option(*command, a->engine);
  add_thread_options(*command, a->threads);
  add_picture_options(*command, a->picture);
  command->footer(
      "Ctrl-C ends the work and writes the best remesh so far. For the thesis's tessellation, "
      "with\n"
      "regions, seeds on nodes and metrics, use relax.");
  command->callback([a] { run_remesh(*a); });
}

}  // namespace geolloyd
