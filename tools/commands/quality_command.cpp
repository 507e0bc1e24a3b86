#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <array>
#include <filesystem>
#include <memory>

#include "geolloyd/errors.h"
#include "geolloyd/threads.h"
#include "tools/cli/number_option.h"
#include "tools/cli/reading_options.h"
#include "tools/cli/remesh_arguments.h"
#include "tools/cli/summary_options.h"
#include "tools/commands/commands.h"
#include "tools/files/output_folder.h"
#include "tools/report/quality_output.h"
#include "tools/run/quality.h"
#include "tools/run/stages.h"
#include "tools/words/mesh_files.h"

namespace geolloyd {
namespace {

struct QualityArguments {
  QualityInput input;
  std::filesystem::path output;
  ThreadArguments threads;
};

void run_quality(const QualityArguments& a, const Console& console) {
  const QualityInput& input = a.input;
  if (input.original.empty() && !input.field.vfield.empty()) {
    throw InvalidInput("--vfield: of which mesh? Give --original MESH, too");
  }
  if (input.original.empty() && input.certify) {
    throw InvalidInput("--certify: the distance to which mesh? Give --original MESH, too");
  }
  const FieldSource& field = input.field;
  check_has_magnitudes(field);
  if (!a.output.empty()) {
    check_target(a.output, std::array{input.remesh, input.original, field.field_file()});
  }
  Scheduler scheduler = make_scheduler(a.threads);
  Threads runtime(scheduler);
  ProgressLine progress(console);
  const QualityRecord record = judge(input, runtime, progress);
  if (!a.output.empty()) write_text_file(a.output, quality_report(record));
  if (console.wants_json()) console.print_json(quality_report(record));
  fmt::print("{}", quality_text(record));
}

}  // namespace

void add_quality_command(CLI::App& program, Console& console) {
  CLI::App* command = program.add_subcommand(
      "quality", "Judge a remesh of any program: triangles, valences, distance to the original");
  const auto a = std::make_shared<QualityArguments>();
  QualityInput& input = a->input;
  input.samples = 500'000;
  command->add_option("REMESH", input.remesh, input_mesh_text)->type_name("")->required();
  command->add_option("--original", input.original, "Mesh that the remesh was made from")
      ->type_name("MESH");
  whole_number(command->add_option("--samples", input.samples,
                                   "Number of points on each mesh to measure distances from"),
               1, 1'000'000'000)
      ->capture_default_str();
  command->add_flag("--certify", input.certify,
                    "Find bounds of the Hausdorff distance, 1 % apart, too");
  command
      ->add_option("--vfield", input.field.vfield,
                   "Judge triangles, edges and energy in a metric of the original, too:\n"
                   "that of a file as of relax, or of its curvature")
      ->type_name("FILE|curvature");
  command->add_option("-o,--output", a->output, "JSON file for all figures")->type_name("FILE");
  add_json_option(*command, console);
  add_reading_options(*command, input.reading);
  add_thread_options(*command, a->threads);
  command->callback([a, &console] { run_quality(*a, console); });
}

}  // namespace geolloyd
