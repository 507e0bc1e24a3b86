#include <memory>
#include <string>

#include "core/formats/mesh_io.h"
#include "tools/cli/choice_option.h"
#include "tools/cli/number_option.h"
#include "tools/cli/reading_options.h"
#include "tools/cli/summary_options.h"
#include "tools/commands/commands.h"
#include "tools/files/mesh_target.h"
#include "tools/report/written_mesh.h"
#include "tools/system/memory_estimate.h"
#include "tools/system/progress.h"
#include "tools/words/names.h"

namespace geolloyd {
namespace {

struct GenerateArguments {
  Shape shape = nullptr;
  MeshTarget output;
  std::size_t triangles = 1'000'000;
  std::uint64_t random_seed = 1;
};

}  // namespace

void add_generate_command(CLI::App& program, Console& console) {
  CLI::App* command = program.add_subcommand("generate", "Generate a mesh of a shape");
  const auto arguments = std::make_shared<GenerateArguments>();
  add_choice(*command, "SHAPE", arguments->shape, shape_names, "Shape of the mesh")->required();
  add_output_option(*command, arguments->output, "File to write");
  whole_number(command->add_option("-t,--triangles", arguments->triangles,
                                   "Least number of triangles; the shape may need a few more"),
               1)
      ->capture_default_str();
  whole_number(
      command->add_option("--random-seed", arguments->random_seed, "Number that varies the shape"),
      0)
      ->capture_default_str();
  add_json_option(*command, console);
  command->callback([arguments, &console] {
    prepare_target(arguments->output, {}, {}, console);
    if (arguments->triangles <= most_triangles) {  // else there are no ids for them
      ProgressLine(console).announce_memory(arguments->output.name(),
                                            bytes_to_make(arguments->triangles, 0));
    }
    const Mesh mesh = arguments->shape(arguments->triangles, arguments->random_seed);
    write(arguments->output, mesh);
    print_written_mesh("generate", arguments->output, mesh, console);
  });
}

}  // namespace geolloyd
