#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_topology.h"
#include "tools/cli/summary_options.h"
#include "tools/commands/commands.h"
#include "tools/report/report_parts.h"
#include "tools/run/input.h"
#include "tools/run/memory_need.h"
#include "tools/system/memory_limit.h"
#include "tools/system/summary.h"
#include "tools/words/facts_text.h"
#include "tools/words/mesh_files.h"

namespace geolloyd {
namespace {

void run_info(const std::filesystem::path& file) {
  Input input{file, read_within_limits(file), {}, {}};
  announce_memory(file.string(), bytes_to_read(size_of(input.loaded)));
  const MeshEdges edges = find_edges(input.mesh());
  input.facts = check_mesh(input.mesh(), edges);
  const MeshTopology topology = find_topology(input.mesh(), edges);
  if (wants_json()) {
    Json facts = mesh_part(input);
    facts.update(topology_part(topology));
    facts["is_manifold"] = topology.is_manifold();
    print_json(json_text(facts));
  }
  fmt::print("{}\n{}  {:<12}{}\n", file.string(), describe(input.loaded, input.facts), "topology",
             describe(topology));
}

}  // namespace

void add_info_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("info", "Print mesh statistics");
  const auto mesh = std::make_shared<std::filesystem::path>();
  command->add_option("MESH", *mesh, input_mesh_text)->type_name("")->required();
  add_json_option(*command);
  command->callback([mesh] { run_info(*mesh); });
}

}  // namespace geolloyd
