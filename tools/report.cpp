#include "tools/report.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include "tools/names.h"

namespace geolloyd {
namespace {

using Json = nlohmann::ordered_json;

Json input_part(const RunRecord& run) {
  const MeshFacts& facts = run.facts;
  return {{"file", run.arguments.mesh.string()},
          {"format", run.input.format},
          {"vertices", facts.vertices},
          {"edges", facts.edges},
          {"triangles", facts.triangles},
          {"polygons_split", run.input.polygon_count},
          {"corners_welded", run.input.welded_corners},
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

Json limit(std::uint32_t value) {
  return value == RelaxationOptions::no_limit ? Json(nullptr) : Json(value);
}

Json path_or_null(const std::filesystem::path& path) {
  return path.empty() ? Json(nullptr) : Json(path.string());
}

Json options_part(const RunRecord& run) {
  const RelaxArguments& a = run.arguments;
  const bool parallel = a.engine == "parallel";
  return {{"engine", a.engine},
          {"threads", run.threads},
          {"frontier", parallel ? Json(a.frontier) : Json(nullptr)},
          {"backend", parallel ? Json(a.backend) : Json(nullptr)},
          {"graph", a.graph},
          {"norm", a.norm},
          {"vfield", path_or_null(a.vfield)},
          {"seeds", run.regions.size()},
          {"seeds_file", path_or_null(a.seeds_file)},
          {"init", a.seeds_file.empty() ? Json(a.init) : Json(nullptr)},
          {"random_seed", a.random_seed},
          {"greedy", a.greedy},
          {"microstep_skip", !a.no_microstep_skip},
          {"macrostep_skip", !a.no_macrostep_skip},
          {"max_greedy_steps", limit(a.max_greedy_steps)},
          {"max_macrosteps", limit(a.max_macrosteps)}};
}

Json graph_part(const RunRecord& run) {
  const Graph& graph = run.mesh_graph.graph;
  return {{"nodes", graph.node_count()},
          {"arcs", graph.arc_count()},
          {"components", run.components},
          {"tick_length", graph.tick_length},
          {"tick_mass", graph.tick_mass}};
}

Json kernel_seconds(const KernelSeconds& s) {
  return {{"free_search", s.free_search},   {"locked_search", s.locked_search},
          {"subtree_sums", s.subtree_sums}, {"scoring", s.scoring},
          {"movement", s.movement},         {"other", s.other}};
}

Json trace_part(const Relaxation& relaxation) {
  Json trace = Json::array();
  for (const Step& step : relaxation.steps) {
    Json entry = {{"phase", step.phase == Phase::greedy ? "greedy" : "precise"},
                  {"seeds_moved", step.seeds_moved},
                  {"node_visits", step.node_visits},
                  {"energy", step.energy},
                  {"state", fingerprint_text(step.state)},
                  {"kernel_seconds", kernel_seconds(step.seconds)}};
    if (step.phase == Phase::precise) {
      Json microsteps = Json::array();
      for (const Microstep& m : step.microsteps) {
        microsteps.push_back({{"seeds_moved", m.seeds_moved}, {"node_visits", m.node_visits}});
      }
      entry["microsteps"] = std::move(microsteps);
    }
    trace.push_back(std::move(entry));
  }
  return trace;
}

Json steps_part(const Relaxation& relaxation) {
  const StepCounts counts = count_steps(relaxation);
  return {{"greedy", counts.greedy},
          {"macro", counts.macro},
          {"micro", counts.micro},
          {"partitions", counts.partitions},
          {"node_visits", counts.node_visits}};
}

}  // namespace

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

std::string fingerprint_text(std::uint64_t fingerprint) {
  return fmt::format("{:016x}", fingerprint);
}

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

Json make_report(const RunRecord& run) {
  const Relaxation& relaxation = run.relaxation;
  Json report;
  report["program"] = "geolloyd " GEOLLOYD_VERSION;
  report["input"] = input_part(run);
  report["options"] = options_part(run);
  report["graph"] = graph_part(run);
  report["end"] = name_of(end_names, relaxation.end);
  report["interrupted"] = relaxation.end == End::interrupted;
  report["steps"] = steps_part(relaxation);
  report["energy_initial"] = initial_energy(relaxation);
  report["energy"] = relaxation.energy;
  report["energy_ratio_hexagonal"] = relaxation.energy / hexagonal_energy(run);
  report["fingerprint"] = fingerprint_text(relaxation.fingerprint);
  report["seconds"] = {{"load", run.seconds.load},   {"graph", run.seconds.graph},
                       {"seeds", run.seconds.seeds}, {"relax", run.seconds.relax},
                       {"write", run.seconds.write}, {"total", run.seconds.total}};
  report["peak_memory_bytes"] = run.peak_memory_bytes;
  report["trace"] = trace_part(relaxation);
  return report;
}

std::string report_text(const RunRecord& run) {
  return make_report(run).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace geolloyd
