#include <fmt/format.h>
#include <CLI/App.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "core/base/stopwatch.h"
#include "tools/cli/surface_remesh_arguments.h"
#include "tools/commands/commands.h"
#include "tools/report/surface_remesh_output.h"
#include "tools/run/carrying.h"
#include "tools/run/stages.h"
#include "tools/run/surface_remesh.h"
#include "tools/run/tolerance_search.h"
#include "tools/system/interrupt.h"
#include "tools/system/machine.h"
#include "tools/system/progress.h"

namespace geolloyd {
namespace {

// What the command line asks of a remesh, of one mesh.
class Remesher {
 public:
  Remesher(const SurfaceRemeshArguments& arguments, LoadedInput& loaded, Scheduler& scheduler,
           ProgressLine& progress)
      : arguments_(arguments),
        loaded_(loaded),
        make_engine_(make_surface_engines(arguments.engine, scheduler)),
        scheduler_(scheduler),
        progress_(progress) {
    options_.sizing = read_sizing(arguments.sizing, loaded);
    options_.field = find_field(arguments.field, loaded.input.mesh(), loaded.edges, scheduler);
    options_.features = read_features(arguments.features, loaded);
    options_.fit = !arguments.no_fit;
  }

  [[nodiscard]] const std::vector<TangentSpace>& field() const { return options_.field; }

  void run(SurfaceRemeshResult& result) {
    const FinenessArguments& fineness = arguments_.fineness;
    if (fineness.tolerance > 0) {
      search(result);
      return;
    }
    options_.edge_length = fineness.edge_length;
    options_.vertex_count = fineness.vertices;
    check_memory(about_how_many(loaded_, options_, scheduler_), result);
    result.made = time_last_remesh(loaded_, options_, make_engine_, scheduler_, progress_);
  }

 private:
  void search(SurfaceRemeshResult& result) {
    const FinenessArguments& fineness = arguments_.fineness;
    const double unit = fineness.is_percentage ? loaded_.input.facts.bounding_diagonal / 100 : 1;
    const std::size_t most =
        std::max<std::size_t>(100'000, 4 * loaded_.input.mesh().vertex_count());
    ToleranceSearch found = search_within(
        fineness.tolerance * unit, most, loaded_,
        [&](std::size_t vertices) {
          check_memory(vertices, result);
          options_.vertex_count = vertices;
          return time_remesh(loaded_, options_, make_engine_, scheduler_, progress_);
        },
        scheduler_, progress_);
    result.made = std::move(found.best);
    result.trials = std::move(found.trials);
  }

  void check_memory(std::size_t vertices, SurfaceRemeshResult& result) {
    const std::uint64_t bytes = check_remesh_memory(
        loaded_, vertices, options_,
        arguments_.picture_file.empty() ? std::nullopt : std::optional(arguments_.picture),
        scheduler_);
    result.memory_estimate = std::max(result.memory_estimate, bytes);
    catch_interrupts();
  }

  const SurfaceRemeshArguments& arguments_;
  LoadedInput& loaded_;
  MakeSurfaceEngine make_engine_;
  Scheduler& scheduler_;
  ProgressLine& progress_;
  SurfaceRemeshOptions options_;
};

// Whose numbers a repair would change; empty: none is given.
std::string option_that_names_vertices(const SurfaceRemeshArguments& arguments) {
  if (!arguments.sizing.lengths_file.empty()) return "--sizing";
  if (!arguments.sizing.densities_file.empty()) return "--density";
  if (!arguments.features.edges_file.empty()) return "--feature-edges";
  if (!arguments.features.fixed_file.empty()) return "--fixed";
  if (!arguments.field.field_file().empty()) return "--vfield";
  return arguments.map_file.empty() ? "" : "--map";
}

void run_remesh(const SurfaceRemeshArguments& arguments) {
  check_fineness(arguments.fineness, arguments.sizing);
  check_has_magnitudes(arguments.field);
  check_repair(arguments.repair, option_that_names_vertices(arguments));
  check_remesh_targets(arguments);
  const Stopwatch total;
  ProgressLine progress;
  Scheduler scheduler = make_scheduler(arguments.threads);
  LoadedInput loaded = load_surface(
      arguments.mesh, scheduler, progress,
      {arguments.carries_properties || !arguments.features.labels.empty()}, arguments.repair);
  SurfaceRemeshResult result;
  result.threads = arguments.engine == EngineKind::reference ? 1 : scheduler.threads();
  Remesher remesher(arguments, loaded, scheduler, progress);
  remesher.run(result);
  const SurfaceRemesh& remesh = result.made.remesh;

  progress.stage("carrying properties over");
  const Properties none;
  result.properties = carry_properties(
      loaded.input.mesh(), arguments.carries_properties ? loaded.input.loaded.properties : none,
      remesh, scheduler);
  const SurfaceColours colours = colours_of(result.properties);
  keep_writable(arguments.output, result.properties);

  progress.stage("measuring the remesh");
  const Stopwatch judging;
  result.figures = judge_remesh(loaded, remesh, remesher.field(), scheduler);
  result.judge_seconds = judging.seconds();

  progress.stage("writing " + arguments.output.string());
  const Stopwatch writing;
  FileGroup files = open_remesh_files(arguments);
  write_remesh(arguments, result, files);
  result.write_seconds = writing.seconds();
  result.total_seconds = total.seconds();
  result.peak_memory_bytes = peak_memory_bytes();
  write_remesh_report(arguments, loaded, result, files);
  if (!arguments.picture_file.empty()) {  // whatever happens to it, the results are there
    progress.stage("drawing " + arguments.picture_file.string());
    write_remesh_picture(arguments, remesh.mesh, colours, scheduler);
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
  add_fineness_options(*command, a->fineness);
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
  add_sizing_options(*command, a->sizing);
  add_field_option(*command, a->field,
                   "Triangles regular in a metric: curvature, for that of the\n"
                   "surface's own curvatures, or a file as of relax. Without other\n"
                   "sizes, all edges have one length in it");
  add_repair_options(*command, a->repair);
  add_feature_options(*command, a->features);
  command->add_flag("--no-fit", a->no_fit,
                    "Leave vertices on the surface of the input, instead of moving them\n"
                    "off it where that brings the triangles closer");
  add_drop_option(*command, a->carries_properties);
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
