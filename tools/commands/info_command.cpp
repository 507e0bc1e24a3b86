#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_topology.h"
#include "tools/commands/commands.h"
#include "tools/report/report_parts.h"
#include "tools/run/input.h"
#include "tools/system/memory_estimate.h"
#include "tools/system/memory_limit.h"
#include "tools/words/facts_text.h"
#include "tools/words/mesh_files.h"

namespace geolloyd {
namespace {

struct InfoArguments {
  std::filesystem::path mesh;
  bool json = false;
};

void run_info(const InfoArguments& arguments) {
  Input input{arguments.mesh, read_within_limits(arguments.mesh), {}, {}};
  announce_memory(arguments.mesh.string(),
                  memory_to_check(input.mesh().vertex_count(), input.mesh().triangle_count()));
  const MeshEdges edges = find_edges(input.mesh());
  input.facts = check_mesh(input.mesh(), edges);
  const MeshTopology topology = find_topology(input.mesh(), edges);
  if (arguments.json) {
    Json facts = mesh_part(input);
    facts.update(topology_part(topology));
    facts["is_manifold"] = topology.is_manifold();
    fmt::print("{}", json_text(facts));
    return;
  }
  fmt::print("{}\n{}  {:<12}{}\n", arguments.mesh.string(), describe(input.loaded, input.facts),
             "topology", describe(topology));
}

}  // namespace

void add_info_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("info", "Print mesh statistics");
  const auto arguments = std::make_shared<InfoArguments>();
  command->add_option("MESH", arguments->mesh, input_mesh_text)->type_name("")->required();
  command->add_flag("--json", arguments->json, "Print JSON, for scripts");
  command->callback([arguments] { run_info(*arguments); });
}

}  // namespace geolloyd
