#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/formats/mesh_io.h"
#include "core/mesh/subdivide.h"
#include "tools/cli/choice_option.h"
#include "tools/cli/reading_options.h"
#include "tools/cli/summary_options.h"
#include "tools/commands/commands.h"
#include "tools/files/mesh_target.h"
#include "tools/report/written_mesh.h"
#include "tools/run/input.h"
#include "tools/system/memory_estimate.h"
#include "tools/system/memory_limit.h"
#include "tools/system/progress.h"
#include "tools/words/mesh_files.h"
#include "tools/words/names.h"

namespace geolloyd {
namespace {

struct Scheme {
  Mesh (*subdivide)(const Mesh& mesh);
  std::uint64_t pieces;  // of a triangle
};

const std::vector<Named<Scheme>> scheme_names = {
    {"midpoint", {subdivide_midpoint, 4}},
    {"barycentric", {subdivide_barycentric, 6}},
};

struct SubdivideArguments {
  std::filesystem::path mesh;
  MeshReading reading;
  MeshTarget output;
  std::vector<Scheme> schemes;
};

// The last of the schemes makes the largest mesh.
void check_memory(const std::string& what, const Mesh& mesh, const std::vector<Scheme>& schemes,
                  const Console& console) {
  std::uint64_t triangles = mesh.triangle_count();
  std::uint64_t bytes = 0;
  for (const Scheme& scheme : schemes) {
    const std::uint64_t before = std::exchange(triangles, scheme.pieces * triangles);
    bytes = bytes_to_make(triangles, before);
    require_memory(what, bytes);
  }
  ProgressLine(console).announce_memory(what, bytes);
}

}  // namespace

void add_subdivide_command(CLI::App& program, Console& console) {
  CLI::App* command = program.add_subcommand(
      "subdivide", "Subdivide the triangles of a mesh; the surface stays the same");
  const auto arguments = std::make_shared<SubdivideArguments>();
  command->add_option("MESH", arguments->mesh, input_mesh_text)->type_name("")->required();
  add_choice_list(*command, "-s,--scheme", arguments->schemes, scheme_names,
                  "midpoint splits a triangle into 4, barycentric into 6; schemes separated\n"
                  "by commas are applied in turn")
      ->required();
  add_output_option(*command, arguments->output, "File to write");
  add_json_option(*command, console);
  add_reading_options(*command, arguments->reading);
  command->callback([arguments, &console] {
    prepare_target(arguments->output, arguments->reading.format, {&arguments->mesh, 1}, console);
    Mesh mesh = read_within_limits(arguments->mesh, {false, arguments->reading}).mesh;
    check_memory(arguments->output.name(), mesh, arguments->schemes, console);
    for (const Scheme& scheme : arguments->schemes) {
      mesh = scheme.subdivide(mesh);
    }
    write(arguments->output, mesh);
    print_written_mesh("subdivide", arguments->output, mesh, console);
  });
}

}  // namespace geolloyd
