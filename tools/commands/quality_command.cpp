#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <vector>

#include "geolloyd/errors.h"
#include "geolloyd/threads.h"
#include "tools/cli/number_option.h"
#include "tools/cli/reading_options.h"
#include "tools/cli/remesh_arguments.h"
#include "tools/cli/summary_options.h"
#include "tools/commands/commands.h"
#include "tools/files/file_group.h"
#include "tools/files/output_folder.h"
#include "tools/report/issues_output.h"
#include "tools/report/quality_output.h"
#include "tools/run/quality.h"
#include "tools/run/stages.h"
#include "tools/words/mesh_files.h"

namespace geolloyd {
namespace {

struct QualityArguments {
  QualityInput input;
  std::filesystem::path issues;  // empty: none
  std::filesystem::path output;  // empty: none
  ThreadArguments threads;
};

// The last one appears last.
std::vector<std::filesystem::path> outputs_of(const QualityArguments& a) {
  std::vector<std::filesystem::path> files;
  for (const auto& file : {a.issues, a.output}) {
    if (!file.empty()) files.push_back(file);
  }
  return files;
}

void check_targets(const QualityArguments& a) {
  std::vector<std::filesystem::path> others = {a.input.remesh, a.input.original,
                                               a.input.field.field_file()};
  for (const auto& file : outputs_of(a)) {
    check_target(file, others);
    others.push_back(file);
  }
}

void write_files(const QualityArguments& a, const QualityRecord& record) {
  const std::vector<std::filesystem::path> names = outputs_of(a);
  if (names.empty()) return;
  FileGroup files(names);
  if (!a.issues.empty()) {
    write_issues(record.remesh.input.mesh(), record.self_intersections, files[0]);
  }
  if (!a.output.empty()) files[names.size() - 1].text(quality_report(record));
  files.commit();
}

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
  check_targets(a);
  Scheduler scheduler = make_scheduler(a.threads);
  Threads runtime(scheduler);
  ProgressLine progress(console);
  const QualityRecord record = judge(input, runtime, progress);
  write_files(a, record);
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
  add_issues_option(*command, a->issues);
  command->add_option("-o,--output", a->output, "JSON file for all figures")->type_name("FILE");
  add_json_option(*command, console);
  add_reading_options(*command, input.reading);
  add_thread_options(*command, a->threads);
  command->callback([a, &console] { run_quality(*a, console); });
}

}  // namespace geolloyd
