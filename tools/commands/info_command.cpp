#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/mesh/mesh_topology.h"
#include "tools/cli/reading_options.h"
#include "tools/cli/summary_options.h"
#include "tools/commands/commands.h"
#include "tools/report/report_parts.h"
#include "tools/run/input.h"
#include "tools/run/memory_need.h"
#include "tools/system/progress.h"
#include "tools/words/facts_text.h"
#include "tools/words/mesh_files.h"

namespace geolloyd {
namespace {

struct InfoArguments {
  std::filesystem::path mesh;
  MeshReading reading;
};

void run_info(const InfoArguments& arguments, const Console& console) {
  const std::filesystem::path& file = arguments.mesh;
  Input input{file, read_within_limits(file, {false, arguments.reading}), {}, {}};
  ProgressLine(console).announce_memory(file.string(), bytes_to_read(size_of(input.loaded)));
  const MeshEdges edges = find_edges(input.mesh());
  input.facts = find_facts(input.loaded, edges);
  const MeshTopology topology = find_topology(input.mesh(), edges);
  if (console.wants_json()) {
    Json facts = mesh_part(input);
    facts.update(topology_part(topology));
    facts["is_manifold"] = topology.is_manifold();
    console.print_json(json_text(facts));
  }
  fmt::print("{}\n{}  {:<12}{}\n", file.string(), describe(input.loaded, input.facts), "topology",
             describe(topology));
}

}  // namespace

void add_info_command(CLI::App& program, Console& console) {
  CLI::App* command = program.add_subcommand("info", "Print mesh statistics");
  const auto a = std::make_shared<InfoArguments>();
  command->add_option("MESH", a->mesh, input_mesh_text)->type_name("")->required();
  add_json_option(*command, console);
  add_reading_options(*command, a->reading);
  command->callback([a, &console] { run_info(*a, console); });
}

}  // namespace geolloyd
