#include "tools/report/report.h"

#include <nlohmann/json.hpp>

#include "tools/report/ground_truth_output.h"
#include "tools/report/report_parts.h"
#include "tools/system/build_facts.h"
#include "tools/words/names.h"

namespace geolloyd {
namespace {

Json engine_part(const RunRecord& run) {
  const RelaxArguments& a = run.arguments;
  const bool parallel = value_of(engine_names, a.engine) == EngineKind::parallel;
  return {{"engine", a.engine},
          {"threads", run.threads},
          {"frontier", parallel ? Json(a.frontier) : Json(nullptr)},
          {"backend", parallel ? Json(a.backend) : Json(nullptr)}};
}

Json resumed_part(const RunRecord& run) {
  if (!run.resumed) return nullptr;
  return {{"from_step", run.resumed->steps}, {"seconds_before", run.resumed->seconds}};
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

Json violations_part(std::span<const ClosedBallViolation> violations) {
  return {{"regions_not_discs", count(violations, ViolationKind::region)},
          {"contacts_not_curves", count(violations, ViolationKind::contact)},
          {"triples_with_several_corners", count(violations, ViolationKind::triple)},
          {"regions_without_corner", count(violations, ViolationKind::isolation)}};
}

Json remesh_part(const Remesh& remesh) {
  return {{"vertices", remesh.mesh.vertex_count()},
          {"triangles", remesh.mesh.triangle_count()},
          {"seeds_added", remesh.seeds_added},
          {"reassigned_points", remesh.reassigned_points},
          {"is_manifold_of_input_topology", remesh.flaw.empty()},
          {"flaw", remesh.flaw.empty() ? Json(nullptr) : Json(remesh.flaw)},
          {"topology", topology_part(remesh.topology)},
          {"input_topology", topology_part(remesh.input_topology)},
          {"repeated_triangles", remesh.repeated},
          {"folded_triangles", remesh.folded},
          {"flipped_triangles", remesh.flipped},
          {"closed_ball_violations_found", violations_part(remesh.violations_found)},
          {"closed_ball_violations_left", violations_part(remesh.violations_left)}};
}

Json make_report(const RunRecord& run) {
  const Relaxation& relaxation = run.relaxation;
  Json report;
  report["program"] = program_name();
  report["machine"] = machine_part();
  report["input"] = mesh_part(run.arguments.mesh, run.input, run.facts);
  report["options"] = engine_part(run);
  report["options"].update(options_part(run.arguments, run.regions.size()));
  report["options"]["manifold"] = run.arguments.manifold;
  report["options"]["remesh_vertices"] = run.arguments.remesh_vertices;
  report["graph"] = graph_part(run.mesh_graph.graph, run.components);
  report["end"] = name_of(stop_reason_names, relaxation.stop_reason);
  report["interrupted"] = run.interrupted;
  report["resumed"] = resumed_part(run);
  report["steps"] = steps_part(count_steps(relaxation));
  report["energy_initial"] = initial_energy(relaxation);
  report["energy"] = relaxation.energy;
  report["energy_ratio_hexagonal"] = relaxation.energy / hexagonal_energy(run);
  const RegionSpread areas = region_spread(run.regions);
  report["region_area"] = {
      {"deviation", areas.deviation}, {"smallest", areas.smallest}, {"largest", areas.largest}};
  report["isoperimetric_ratio"] = {{"mean", run.remesh.roundness.mean},
                                   {"min", run.remesh.roundness.min}};
  report["remesh"] = remesh_part(run.remesh);
  if (run.ground_truth) report["ground_truth"] = ground_truth_part(*run.ground_truth);
  report["fingerprint"] = fingerprint_text(relaxation.fingerprint);
  report["seconds"] = {{"load", run.seconds.load},
                       {"graph", run.seconds.graph},
                       {"seeds", run.seconds.seeds},
                       {"relax", run.seconds.relax},
                       {"ground_truth", run.seconds.ground_truth},
                       {"remesh", run.seconds.remesh},
                       {"write", run.seconds.write},
                       {"total", run.seconds.total}};
  report["memory_estimate_bytes"] = run.memory_estimate;
  report["peak_memory_bytes"] = run.peak_memory_bytes;
  report["trace"] = trace_part(relaxation);
  return report;
}

}  // namespace

std::string report_text(const RunRecord& run) {
  return json_text(make_report(run));
}

}  // namespace geolloyd
