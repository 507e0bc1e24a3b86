#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "core/mesh/mesh_check.h"
#include "tools/commands/commands.h"
#include "tools/run/input.h"
#include "tools/system/memory_estimate.h"
#include "tools/system/memory_limit.h"
#include "tools/words/facts_text.h"

namespace geolloyd {

void add_info_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("info", "Say what a mesh is like");
  const auto path = std::make_shared<std::filesystem::path>();
  command->add_option("MESH", *path, "PLY, OBJ, OFF or STL file")->type_name("")->required();
  command->callback([path] {
    const LoadedMesh input = read_within_limits(*path);
    announce_memory(path->string(),
                    memory_to_check(input.mesh.vertex_count(), input.mesh.triangle_count()));
    fmt::print("{}\n{}", path->string(),
               describe(input, check_mesh(input.mesh, find_edges(input.mesh))));
  });
}

}  // namespace geolloyd
