#include "tools/report.h"

#include <nlohmann/json.hpp>

#include "tools/ground_truth_output.h"
#include "tools/names.h"
#include "tools/report_parts.h"

namespace geolloyd {
namespace {

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

Json engine_part(const RunRecord& run) {
  const RelaxArguments& a = run.arguments;
  const bool parallel = value_of(engine_names, a.engine) == EngineKind::parallel;
  return {{"engine", a.engine},
          {"threads", run.threads},
          {"frontier", parallel ? Json(a.frontier) : Json(nullptr)},
          {"backend", parallel ? Json(a.backend) : Json(nullptr)}};
}

Json trace_part(const Relaxation& relaxation) {
  Json trace = Json::array();
  for (const Step& step : relaxation.steps) {
    Json entry = {{"phase", name_of(phase_names, step.phase)},
                  {"seeds_moved", step.seeds_moved},
                  {"node_visits", step.node_visits},
                  {"energy", step.energy},
                  {"state", fingerprint_text(step.state)},
                  {"kernel_seconds", kernel_seconds_part(step.seconds)}};
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

Json make_report(const RunRecord& run) {
  const Relaxation& relaxation = run.relaxation;
  Json report;
  report["program"] = "geolloyd " GEOLLOYD_VERSION;
  report["machine"] = machine_part();
  report["input"] = input_part(run);
  report["options"] = engine_part(run);
  report["options"].update(options_part(run.arguments, run.regions.size()));
  report["graph"] = graph_part(run.mesh_graph.graph, run.components);
  report["end"] = name_of(end_names, relaxation.end);
  report["interrupted"] = relaxation.end == End::interrupted;
  report["steps"] = steps_part(count_steps(relaxation));
  report["energy_initial"] = initial_energy(relaxation);
  report["energy"] = relaxation.energy;
  report["energy_ratio_hexagonal"] = relaxation.energy / hexagonal_energy(run);
  if (run.ground_truth) report["ground_truth"] = ground_truth_part(*run.ground_truth);
  report["fingerprint"] = fingerprint_text(relaxation.fingerprint);
  report["seconds"] = {{"load", run.seconds.load},
                       {"graph", run.seconds.graph},
                       {"seeds", run.seconds.seeds},
                       {"relax", run.seconds.relax},
                       {"ground_truth", run.seconds.ground_truth},
                       {"write", run.seconds.write},
                       {"total", run.seconds.total}};
  report["peak_memory_bytes"] = run.peak_memory_bytes;
  report["trace"] = trace_part(relaxation);
  return report;
}

}  // namespace

std::string report_text(const RunRecord& run) {
  return json_text(make_report(run));
}

}  // namespace geolloyd
