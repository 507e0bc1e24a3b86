#include "tools/report/report.h"

#include <nlohmann/json.hpp>

#include "core/base/hexagonal_energy.h"
#include "tools/report/dual_output.h"
#include "tools/report/ground_truth_output.h"
#include "tools/report/report_parts.h"
#include "tools/system/build_facts.h"
#include "tools/words/names.h"

namespace geolloyd {
namespace {

Json engine_part(const RelaxFacts& facts, std::size_t threads) {
  return {{"engine", name_of(engine_names, facts.engine)},
          {"threads", threads},
          {"frontier", frontier_part(facts.engine, facts.frontier)},
          {"backend", backend_part(facts.engine, facts.backend)}};
}

Json resumed_part(const std::optional<EarlierPart>& resumed) {
  if (!resumed) return nullptr;
  return {{"from_step", resumed->steps}, {"seconds_before", resumed->seconds}};
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
    if (step.phase != Phase::greedy) {
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

Json options_part(const RelaxFacts& facts, const Result& result) {
  Json part = engine_part(facts, result.threads);
  part.update(options_part(facts.request, facts.options, result.regions.size()));
  part["repair"] = facts.request.repair.has_value();
  part["fill_holes"] = fill_holes_part(facts.request.repair);
  part["weld"] = facts.request.reading.weld;
  part["drop"] = !facts.request.has_properties;
  part["manifold"] = facts.dual.manifold;
  part["dual_vertices"] = name_of(dual_vertices_names, facts.dual.vertices);
  return part;
}

Json seconds_part(const PreparedInput& start, const Cost& cost) {
  return {{"load", start.load_seconds},
          {"graph", start.seconds.graph},
          {"seeds", start.seconds.seeds},
          {"relax", cost.relax_seconds},
          {"ground_truth", cost.ground_truth_seconds},
          {"dual", cost.dual_seconds},
          {"write", cost.write_seconds},
          {"total", cost.total_seconds}};
}

}  // namespace

double hexagonal_energy(std::span<const RegionSummary> regions, const MeshFacts& facts) {
  double mass = 0;
  for (const RegionSummary& region : regions) mass += region.area;
  return hexagonal_energy(mass, facts.area, regions.size());
}

std::string report_text(const RelaxFacts& facts, const PreparedInput& start, const Result& result,
                        const Cost& cost) {
  const Relaxation& relaxation = result.relaxation;
  Json report;
  report["program"] = program_name();
  report["machine"] = machine_part();
  report["input"] = mesh_part(start.input);
  report["repairs"] = repairs_part(start.input.repairs);
  report["options"] = options_part(facts, result);
  report["graph"] = graph_part(start.mesh_graph.graph, start.components);
  report["seed_fit"] = seed_fit_part(start.seed_fit);
  report["end"] = name_of(stop_reason_names, relaxation.stop_reason);
  report["interrupted"] = result.interrupted;
  report["resumed"] = resumed_part(result.resumed);
  report["steps"] = steps_part(count_steps(relaxation));
  report["energy_initial"] = initial_energy(relaxation);
  report["energy"] = relaxation.energy;
  report["energy_ratio_hexagonal"] =
      relaxation.energy / hexagonal_energy(result.regions, start.input.facts);
  const RegionSpread areas = region_spread(result.regions);
  report["region_area"] = {
      {"deviation", areas.deviation}, {"smallest", areas.smallest}, {"largest", areas.largest}};
  report["isoperimetric_ratio"] = {{"mean", result.dual->roundness.mean},
                                   {"min", result.dual->roundness.min}};
  report["dual"] = dual_part(*result.dual);
  report["quads"] = quads_part(result.dual->quads);
  report["properties"] = properties_part(result.dual->properties);
  if (result.ground_truth) report["ground_truth"] = ground_truth_part(*result.ground_truth);
  report["fingerprint"] = fingerprint_text(relaxation.fingerprint);
  report["seconds"] = seconds_part(start, cost);
  report["memory_estimate_bytes"] = start.memory_estimate;
  report["peak_memory_bytes"] = cost.peak_memory_bytes;
  report["trace"] = trace_part(relaxation);
  return json_text(report);
}

}  // namespace geolloyd
