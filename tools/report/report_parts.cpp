#include "tools/report/report_parts.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/system/build_facts.h"
#include "tools/system/machine.h"
#include "tools/words/names.h"

namespace geolloyd {
namespace {

Json limit(std::uint32_t value) {
  return value == RelaxationOptions::no_limit ? Json(nullptr) : Json(value);
}

Json path_or_null(const std::filesystem::path& path) {
  return path.empty() ? Json(nullptr) : Json(path.string());
}

// Of a field there may not be.
Json averaging_part(const GraphArguments& graph) {
  if (graph.vfield.empty()) return nullptr;
  return name_of(averaging_names, graph.averaging.value_or(suggested_averaging(graph.norm)));
}

}  // namespace

Json machine_part() {
  const Machine m = this_machine();
  return {{"processor", m.processor},
          {"threads", m.threads},
          {"memory_bytes", m.memory_bytes},
          {"system", m.system},
          {"compiler", m.compiler}};
}

Json begin_result(const std::string& command, const Input& input) {
  return {{"program", program_name()},
          {"command", command},
          {"machine", machine_part()},
          {"mesh",
           {{"file", input.file.string()},
            {"vertices", input.facts.vertices},
            {"triangles", input.facts.triangles}}}};
}

Json mesh_part(const Input& input) {
  const MeshFacts& facts = input.facts;
  return {{"file", input.file.string()},
          {"format", input.loaded.format},
          {"vertices", facts.vertices},
          {"edges", facts.edges},
          {"triangles", facts.triangles},
          {"polygons_split", input.loaded.polygon_count},
          {"corners_welded", input.loaded.welded_corners},
          {"unreferenced_vertices", facts.unreferenced_vertices},
          {"repeated_vertex_triangles", facts.repeated_vertex_triangles},
          {"zero_area_triangles", facts.zero_area_triangles},
          {"duplicate_triangles", facts.duplicate_triangles},
          {"boundary_edges", facts.boundary_edges},
          {"non_manifold_edges", facts.non_manifold_edges},
          {"inconsistent_edges", facts.inconsistent_edges},
          {"zero_length_edges", facts.zero_length_edges},
          {"components", facts.components},
          {"euler_characteristic", facts.euler_characteristic},
          {"area", facts.area},
          {"bounding_diagonal", facts.bounding_diagonal}};
}

Json graph_part(const Graph& graph, std::size_t components) {
  return {{"nodes", graph.node_count()},
          {"arcs", graph.arc_count()},
          {"components", components},
          {"tick_length", graph.tick_length},
          {"tick_mass", graph.tick_mass}};
}

Json steps_part(const StepCounts& counts) {
  return {{"greedy", counts.greedy},
          {"macro", counts.macro},
          {"micro", counts.micro},
          {"partitions", counts.partitions},
          {"node_visits", counts.node_visits}};
}

Json topology_part(const MeshTopology& topology) {
  const PartTopology total = topology.total();
  return {{"components", topology.parts.size()},
          {"euler_characteristic", total.euler_characteristic},
          {"boundary_loops", total.boundary_loops},
          {"non_manifold_edges", topology.non_manifold_edges},
          {"non_manifold_vertices", topology.non_manifold_vertices},
          {"inconsistent_edges", topology.inconsistent_edges}};
}

Json kernel_seconds_part(const KernelSeconds& seconds) {
  Json part;
  for (const auto& [name, kernel] : kernel_names) part[name] = seconds.*kernel;
  return part;
}

Json options_part(const StartArguments& start, const RelaxationArguments& relaxation,
                  std::size_t seeds) {
  const SeedArguments& first = start.seeds;
  const RelaxationOptions options = relaxation_options(first, relaxation);
  return {{"graph", name_of(graph_kind_names, start.graph.kind)},
          {"norm", name_of(norm_names, start.graph.norm)},
          {"vfield", path_or_null(start.graph.vfield)},
          {"averaging", averaging_part(start.graph)},
          {"seeds", seeds},
          {"seeds_file", path_or_null(first.file)},
          {"init", first.file.empty() ? Json(name_of(seed_init_names, first.init)) : Json(nullptr)},
          {"random_seed", first.random_seed},
          {"greedy", name_of(greedy_mode_names, options.greedy)},
          {"microstep_skip", options.microstep_skip},
          {"macrostep_skip", options.macrostep_skip},
          {"max_greedy_steps", limit(options.max_greedy_steps)},
          {"max_macrosteps", limit(options.max_macrosteps)}};
}

Json frontier_part(EngineKind engine, Frontier frontier) {
  if (engine == EngineKind::reference) return nullptr;
  return name_of(frontier_names, frontier);
}

Json backend_part(EngineKind engine, Backend backend) {
  if (engine == EngineKind::reference) return nullptr;
  return name_of(backend_names, backend);
}

std::string_view kind_of(const MeshGraph& mesh_graph, std::uint32_t input_id) {
  return mesh_graph.is_triangle(input_id) ? "triangle" : "vertex";
}

Json number_or_null(std::optional<double> value) {
  return value ? Json(*value) : Json(nullptr);
}

std::string fingerprint_text(std::uint64_t fingerprint) {
  return fmt::format("{:016x}", fingerprint);
}

double initial_energy(const Relaxation& relaxation) {
  return relaxation.steps.empty() ? relaxation.energy : relaxation.steps.front().energy;
}

StepCounts count_steps(const Relaxation& relaxation) {
  StepCounts counts;
  for (const Step& step : relaxation.steps) {
    ++(step.phase == Phase::greedy ? counts.greedy : counts.macro);
    ++counts.partitions;
    counts.micro += step.microsteps.size();
    for (const Microstep& m : step.microsteps) counts.partitions += m.node_visits > 0 ? 1 : 0;
    counts.node_visits += step.node_visits;
  }
  return counts;
}

}  // namespace geolloyd
