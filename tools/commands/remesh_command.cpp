#include <fmt/format.h>
#include <CLI/App.hpp>

#include <cstdint>
#include <memory>
#include <string>

#include "core/base/stopwatch.h"
#include "core/formats/mesh_io.h"
#include "tools/cli/format_option.h"
#include "tools/cli/remesh_arguments.h"
#include "tools/cli/summary_options.h"
#include "tools/commands/commands.h"
#include "tools/report/remesh_output.h"
#include "tools/run/remesh_run.h"
#include "tools/run/stages.h"
#include "tools/system/interrupt.h"
#include "tools/system/machine.h"
#include "tools/system/memory_limit.h"
#include "tools/system/progress.h"
#include "tools/view/page.h"
#include "tools/view/page_contents.h"
#include "tools/words/mesh_files.h"

namespace geolloyd {
namespace {

void run_remesh(const RemeshArguments& arguments, const Console& console) {
  if (!arguments.page_file.empty()) check_viewer();
  check_remesh(arguments);
  check_remesh_targets(arguments);
  const Stopwatch total;
  ProgressLine progress(console);
  Scheduler scheduler = make_scheduler(arguments.threads);
  const auto check_memory = [&](std::uint64_t bytes) {
    progress.announce_memory(arguments.mesh.string(), bytes);
    catch_interrupts();
  };
  RemeshedInput done = remesh_input(arguments, check_memory, scheduler, progress);
  RemeshResult& result = done.result;
  const Remesh& remesh = result.made.remesh;
  const SurfaceColours colours = colours_of(result.properties);
  keep_writable(arguments.output, result.properties);

  progress.stage("writing " + arguments.output.string());
  const Stopwatch writing;
  FileGroup files = open_remesh_files(arguments);
  write_remesh(arguments, result, files);
  result.write_seconds = writing.seconds();
  result.total_seconds = total.seconds();
  result.peak_memory_bytes = peak_memory_bytes();
  write_remesh_report(arguments, done.loaded, result, files);
  if (!arguments.picture_file.empty()) {  // whatever happens to it, the results are there
    progress.stage("drawing " + arguments.picture_file.string());
    write_remesh_picture(arguments, remesh.mesh, colours, scheduler);
  }
  std::string page;
  if (!arguments.page_file.empty()) {
    progress.stage("writing " + arguments.page_file.string());
    page = write_page(arguments.page_file, remesh_contents(arguments, done, scheduler));
  }
  progress.clear();
  if (console.wants_json()) console.print_json(remesh_report(arguments, done.loaded, result));
  fmt::print("{}{}", describe(arguments, done.loaded, result), page);
  if (remesh.interrupted) throw InterruptedExit{};
}

}  // namespace

void add_remesh_command(CLI::App& program, Console& console) {
  CLI::App* command = program.add_subcommand(
      "remesh", "Remesh a mesh as regularly as can be: vertices move freely over its surface");
  const auto a = std::make_shared<RemeshArguments>();
  command->add_option("MESH", a->mesh, input_mesh_text)->type_name("")->required();
  add_fineness_options(*command, a->fineness);
  command->add_option("-o,--output", a->output, "File for the remesh: " + output_mesh_text)
      ->type_name("FILE")
      ->required();
  command->add_option("--report", a->report_file, "JSON file for all figures")->type_name("FILE");
  command
      ->add_option("--map", a->map_file,
                   "CSV file that tells where on the input each vertex is: a\n"
                   "triangle, and barycentric coordinates in it")
      ->type_name("FILE");
  command->add_option("--picture", a->picture_file, "PNG file for a picture of the remesh")
      ->type_name("FILE");
  command
      ->add_option("--page", a->page_file,
                   "HTML file that shows the mesh before and after in a browser")
      ->type_name("FILE");
  add_size_file_options(*command, a->sizing);
  add_adapt_options(*command, a->sizing);
  add_field_option(*command, a->field,
                   "Triangles regular in a metric: curvature, for that of the\n"
                   "surface's own curvatures, or a file as of relax. Without other\n"
                   "sizes, all edges have one length in it");
  add_repair_options(*command, a->repair);
  add_feature_options(*command, a->features);
  add_feature_file_options(*command, a->features);
  add_no_fit_option(*command, a->no_fit);
  add_drop_option(*command, a->carries_properties);
  add_engine_option(*command, a->engine);
  add_thread_options(*command, a->threads);
  add_format_option(*command, a->format);
  add_picture_options(*command, a->picture);
  command->footer(
      "Ctrl-C ends the work and writes the best remesh so far. For the thesis's tessellation, "
      "with\n"
      "regions, seeds on nodes and metrics, use relax.");
  add_json_option(*command, console);
  command->callback([a, &console] { run_remesh(*a, console); });
}

}  // namespace geolloyd
