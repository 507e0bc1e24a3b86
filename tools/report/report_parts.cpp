#include "tools/report/report_parts.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

#include "tools/system/build_facts.h"
#include "tools/system/machine.h"
#include "tools/words/facts_text.h"
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
Json averaging_part(const GraphPlan& graph) {
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
          {"vertices_welded", input.loaded.welded_vertices},
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

Json repairs_part(const std::optional<Repairs>& repairs) {
  if (!repairs) return nullptr;
  return {{"any", repairs->any()},
          {"repeated_vertex_triangles", repairs->repeated_vertex_triangles},
          {"duplicate_triangles", repairs->duplicate_triangles},
          {"vertices_cut", repairs->vertices_cut},
          {"vertices_merged", repairs->vertices_merged},
          {"slivers_removed", repairs->slivers_removed},
          {"slivers_left", repairs->slivers_left},
          {"triangles_turned", repairs->triangles_turned},
          {"unorientable_components", repairs->unorientable_components},
          {"holes_filled", repairs->holes_filled},
          {"triangles_added", repairs->triangles_added},
          {"holes_left", repairs->holes_left},
          {"unused_vertices", repairs->unused_vertices}};
}

Json fill_holes_part(const std::optional<RepairOptions>& repair) {
  return repair ? Json(name_of_hole_size(*repair)) : Json(nullptr);
}

Json graph_part(const Graph& graph, std::size_t components) {
  return {{"nodes", graph.node_count()},
          {"arcs", graph.arc_count()},
          {"components", components},
          {"tick_length", graph.tick_length},
          {"tick_mass", graph.tick_mass}};
}

Json steps_part(const StepCounts& counts) {
  return {{"greedy", counts.greedy},           {"macro", counts.macro},
          {"improvement", counts.improvement}, {"micro", counts.micro},
          {"partitions", counts.partitions},   {"node_visits", counts.node_visits}};
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

Json properties_part(const Properties& carried) {
  const auto names = [](const std::vector<Property>& properties) {
    Json part = Json::array();
    for (const Property& property : properties) part.push_back(property.name);
    return part;
  };
  return {{"vertices", names(carried.of_vertices)},
          {"triangles", names(carried.of_triangles)},
          {"left_out", carried.left_out}};
}

Json kernel_seconds_part(const KernelSeconds& seconds) {
  Json part;
  for (const auto& [name, kernel] : kernel_names) part[name] = seconds.*kernel;
  return part;
}

Json options_part(const RunRequest& request, const RelaxationOptions& options, std::size_t seeds) {
  const GraphPlan& graph = request.graph;
  const SeedPlan& chosen = request.seeds;
  const SeedFile& file = request.seed_file;
  const bool are_given = !file.path.empty();
  return {{"graph", name_of(graph_kind_names, graph.kind)},
          {"norm", name_of(norm_names, graph.norm)},
          {"vfield", path_or_null(graph.vfield)},
          {"averaging", averaging_part(graph)},
          {"seeds", seeds},
          {"seeds_file", path_or_null(file.path)},
          {"by", are_given ? Json(name_of(seeds_by_names, file.by)) : Json(nullptr)},
          {"init", are_given ? Json(nullptr) : Json(name_of(seed_init_names, chosen.init))},
          {"random_seed", chosen.random_seed},
          {"greedy", name_of(greedy_mode_names, options.greedy)},
          {"microstep_skip", options.microstep_skip},
          {"macrostep_skip", options.macrostep_skip},
          {"max_greedy_steps", limit(options.max_greedy_steps)},
          {"max_macrosteps", limit(options.max_macrosteps)},
          {"improvement_rounds", limit(options.improvement_rounds)},
          {"improvement_seconds", std::isfinite(options.improvement_seconds)
                                      ? Json(options.improvement_seconds)
                                      : Json(nullptr)}};
}

Json seed_fit_part(const std::optional<PositionFit>& fit) {
  if (!fit) return nullptr;
  return {{"farthest", fit->farthest}, {"left_out", fit->left_out}};
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

namespace {

std::size_t& count_of(Phase phase, StepCounts& counts) {
  switch (phase) {
    case Phase::greedy:
      return counts.greedy;
    case Phase::precise:
      return counts.macro;
    case Phase::improvement:
      break;
  }
  return counts.improvement;
}

}  // namespace

StepCounts count_steps(const Relaxation& relaxation) {
  StepCounts counts;
  for (const Step& step : relaxation.steps) {
    ++count_of(step.phase, counts);
    ++counts.partitions;
    counts.micro += step.microsteps.size();
    for (const Microstep& m : step.microsteps) counts.partitions += m.node_visits > 0 ? 1 : 0;
    counts.node_visits += step.node_visits;
  }
  return counts;
}

}  // namespace geolloyd
