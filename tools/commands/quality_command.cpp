#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <array>
#include <filesystem>
#include <memory>

#include "tools/cli/number_option.h"
#include "tools/commands/commands.h"
#include "tools/files/output_folder.h"
#include "tools/report/quality_output.h"
#include "tools/run/quality.h"
#include "tools/run/stages.h"

namespace geolloyd {
namespace {

struct QualityArguments {
  std::filesystem::path remesh;
  std::filesystem::path original;
  std::filesystem::path output;
  ThreadArguments threads;
  std::size_t samples = 500'000;
};

void run_quality(const QualityArguments& a) {
  if (!a.output.empty()) check_target(a.output, std::array{a.remesh, a.original});
  Scheduler scheduler = make_scheduler(a.threads);
  ProgressLine progress;
  const QualityRecord record = judge(a.remesh, a.original, a.samples, scheduler, progress);
  if (!a.output.empty()) write_text_file(a.output, quality_report(record));
  fmt::print("{}", quality_text(record));
}

}  // namespace

void add_quality_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "quality", "Judge a remesh of any program: triangles, valences, distance to the original");
  const auto a = std::make_shared<QualityArguments>();
  command->add_option("REMESH", a->remesh, "PLY, OBJ, OFF or STL file")->type_name("")->required();
  command->add_option("--original", a->original, "Mesh that the remesh was made from")
      ->type_name("MESH");
  whole_number(command->add_option("--samples", a->samples,
                                   "Number of points on each mesh to measure distances from"),
               1, 1'000'000'000)
      ->capture_default_str();
  command->add_option("-o,--output", a->output, "JSON file for all figures")->type_name("FILE");
  add_thread_options(*command, a->threads);
  command->callback([a] { run_quality(*a); });
}

}  // namespace geolloyd
