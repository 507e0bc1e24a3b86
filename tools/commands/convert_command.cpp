#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "core/formats/mesh_io.h"
#include "tools/cli/reading_options.h"
#include "tools/cli/relax_arguments.h"
#include "tools/cli/summary_options.h"
#include "tools/commands/commands.h"
#include "tools/files/mesh_target.h"
#include "tools/report/written_mesh.h"
#include "tools/run/input.h"
#include "tools/words/mesh_files.h"

namespace geolloyd {
namespace {

struct ConvertArguments {
  std::filesystem::path mesh;
  MeshReading reading{.weld = false};
  MeshTarget output;
  bool carries_properties = true;
};

void run_convert(ConvertArguments& arguments, Console& console) {
  MeshTarget& output = arguments.output;
  prepare_target(output, arguments.reading.format, {&arguments.mesh, 1}, console);
  LoadedMesh loaded =
      read_within_limits(arguments.mesh, {arguments.carries_properties, arguments.reading});
  keep_writable(format_to_write(output), loaded.properties);
  write(output, loaded.mesh, loaded.properties);
  print_converted_mesh(output, loaded, console);
}

}  // namespace

void add_convert_command(CLI::App& program, Console& console) {
  CLI::App* command = program.add_subcommand(
      "convert", "Convert a mesh to another format; the mesh stays the same");
  const auto a = std::make_shared<ConvertArguments>();
  command->add_option("MESH", a->mesh, input_mesh_text)->type_name("")->required();
  command->add_option("OUTPUT", a->output.file, "File to write: " + output_mesh_text)
      ->type_name("")
      ->required();
  add_output_format_option(*command, a->output);
  add_format_option(*command, a->reading);
  add_drop_option(*command, a->carries_properties);
  add_json_option(*command, console);
  command->callback([a, &console] { run_convert(*a, console); });
}

}  // namespace geolloyd
