#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/kernel_seconds.h"
#include "core/graph/graph.h"
#include "core/graph/mesh_graph.h"
#include "core/lloyd/relaxation.h"
#include "core/mesh/mesh_topology.h"
#include "tools/cli/relax_arguments.h"
#include "tools/files/json.h"
#include "tools/run/input.h"

namespace geolloyd {

// What the JSON files of several commands have in common; the README lists the keys.

Json machine_part();
/// The beginning of a result file: program, command, machine, mesh.
Json begin_result(const std::string& command, const Input& input);
Json mesh_part(const Input& input);
/// Null where no repair was asked for.
Json repairs_part(const std::optional<Repairs>& repairs);
/// As --fill-holes has it; null without a repair.
Json fill_holes_part(const std::optional<RepairOptions>& repair);
Json graph_part(const Graph& graph, std::size_t components);
Json topology_part(const MeshTopology& topology);
/// The names of what was carried over, and what was left out.
Json properties_part(const Properties& carried);
Json kernel_seconds_part(const KernelSeconds& seconds);
/// The options in force, but for the engine's: of --greedy auto, the mode chosen.
Json options_part(const StartArguments& start, const RelaxationArguments& relaxation,
                  std::size_t seeds);
/// The reference engine has neither frontier nor backend: null.
Json frontier_part(EngineKind engine, Frontier frontier);
Json backend_part(EngineKind engine, Backend backend);

/// Null where seeds are not given by position.
Json seed_fit_part(const std::optional<PositionFit>& fit);

/// "vertex" or "triangle".
std::string_view kind_of(const MeshGraph& mesh_graph, std::uint32_t input_id);

/// Not a number: null.
Json number_or_null(std::optional<double> value);

/// The fingerprint as 16 hexadecimal digits.
std::string fingerprint_text(std::uint64_t fingerprint);

/// Of the first seeds.
double initial_energy(const Relaxation& relaxation);

/// Sums over the steps of a trace.
struct StepCounts {
  std::size_t greedy = 0;
  std::size_t macro = 0;        ///< of the precise phase
  std::size_t improvement = 0;  ///< rounds
  std::size_t micro = 0;
  std::size_t partitions = 0;  ///< searches, regions free and locked
  std::uint64_t node_visits = 0;
};
StepCounts count_steps(const Relaxation& relaxation);
Json steps_part(const StepCounts& counts);

}  // namespace geolloyd
