#include <fmt/format.h>
#include <CLI/App.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/base/stopwatch.h"
#include "core/formats/mesh_io.h"
#include "tools/cli/reading_options.h"
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
#include "tools/words/warnings_text.h"

namespace geolloyd {
namespace {

void run_remesh(RemeshArguments& arguments, Console& console) {
  RemeshFiles& names = arguments.files;
  if (!names.page.empty()) check_viewer();
  check_remesh(arguments);
  const RemeshRequest& request = arguments.request;
  prepare_remesh_targets(names, request, console);
  const Stopwatch total;
  ProgressLine progress(console);
  Scheduler scheduler = make_scheduler(arguments.threads);
  const auto check_memory = [&](std::uint64_t bytes) {
    progress.announce_memory(request.mesh.string(), bytes);
  };
  const auto picture =
      names.picture.empty() ? std::nullopt : std::optional<PictureLook>(arguments.picture);
  RemeshedInput done =
      remesh_input(request, picture, arguments.engine, check_memory, scheduler, progress);
  RemeshResult& result = done.result;
  const Remesh& remesh = result.made.remesh;
  const SurfaceColours colours = colours_of(result.properties);
  keep_writable(format_to_write(names.remesh), result.properties);

  progress.stage("writing " + names.remesh.name());
  const Stopwatch writing;
  FileGroup files = open_remesh_files(names);
  write_remesh(names, result, files);
  result.write_seconds = writing.seconds();
  result.total_seconds = total.seconds();
  result.peak_memory_bytes = peak_memory_bytes();
  write_remesh_report(names, request, done, files);
  if (!names.picture.empty()) {  // whatever happens to it, the results are there
    progress.stage("drawing " + names.picture.string());
    write_remesh_picture(names.picture, arguments.picture, done, colours, scheduler);
  }
  std::string page;
  if (!names.page.empty()) {
    progress.stage("writing " + names.page.string());
    page = write_page(names.page, remesh_contents(done));
  }
  progress.clear();
  if (console.wants_json()) console.print_json(remesh_report(request, done));
  fmt::print("{}{}", describe(names, done), page);
  tell_warnings(lines_of_warnings(remesh.warnings), arguments.is_strict, console);
  if (remesh.interrupted) throw InterruptedExit{};
  if (arguments.is_strict && !remesh.warnings.empty()) throw WarnedExit{};
}

}  // namespace

void add_remesh_command(CLI::App& program, Console& console) {
  CLI::App* command = program.add_subcommand(
      "remesh", "Remesh a mesh as regularly as can be: vertices move freely over its surface");
  const auto a = std::make_shared<RemeshArguments>();
  RemeshRequest& request = a->request;
  RemeshFiles& files = a->files;
  command->add_option("MESH", request.mesh, input_mesh_text)->type_name("")->required();
  add_fineness_options(*command, request);
  add_output_option(*command, files.remesh, "File for the remesh");
  command->add_option("--report", files.report, "JSON file for all figures")->type_name("FILE");
  command
      ->add_option("--map", files.map,
                   "CSV file that tells where on the input each vertex is: a\n"
                   "triangle, and barycentric coordinates in it")
      ->type_name("FILE");
  add_issues_option(*command, files.issues);
  command->add_option("--picture", files.picture, "PNG file for a picture of the remesh")
      ->type_name("FILE");
  command
      ->add_option("--page", files.page,
                   "HTML file that shows the mesh before and after in a browser")
      ->type_name("FILE");
  add_size_file_options(*command, request);
  add_adapt_options(*command, request);
  add_field_option(*command, request,
                   "Triangles regular in a metric: curvature, for that of the\n"
                   "surface's own curvatures, or a file as of relax. Without other\n"
                   "sizes, all edges have one length in it");
  add_repair_options(*command, a->repair);
  add_feature_options(*command, request);
  add_feature_file_options(*command, request);
  add_no_fit_option(*command, request);
  add_drop_option(*command, request.carries_properties);
  add_engine_option(*command, a->engine);
  add_thread_options(*command, a->threads);
  add_reading_options(*command, request.reading);
  add_picture_options(*command, a->picture);
  command->footer(
      "Ctrl-C ends the work and writes the best remesh so far. For the thesis's tessellation, "
      "with\n"
      "regions, seeds on nodes and metrics, use relax.");
  add_json_option(*command, console);
  add_strict_option(*command, a->is_strict);
  command->callback([a, &console] { run_remesh(*a, console); });
}

}  // namespace geolloyd
