#include "tools/report/remesh_output.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "core/formats/mesh_formats.h"
#include "core/formats/mesh_io.h"
#include "geolloyd/errors.h"
#include "tools/cli/remesh_arguments.h"
#include "tools/files/csv.h"
#include "tools/files/output_folder.h"
#include "tools/render/painters.h"
#include "tools/render/picture.h"
#include "tools/report/issues_output.h"
#include "tools/report/quality_output.h"
#include "tools/report/report_parts.h"
#include "tools/system/build_facts.h"
#include "tools/words/facts_text.h"

namespace geolloyd {
namespace {

// Those of a run, beside the mesh. The last one tells scripts that all are there.
std::vector<std::filesystem::path> other_files_of(const RemeshFiles& names) {
  std::vector<std::filesystem::path> files;
  for (const auto& file : {names.map, names.issues, names.report}) {
    if (!file.empty()) files.push_back(file);
  }
  return files;
}

void write_map(const Remesh& remesh, FileWriter& out) {
  out.text("vertex,triangle,weight_0,weight_1,weight_2\n");
  for (std::size_t v = 0; v < remesh.places.size(); ++v) {
    const auto& [triangle, weight] = remesh.places[v];
    if (triangle == no_id) {
      write_row(out, v, "-1", "nan", "nan", "nan");
    } else {
      write_row(out, v, triangle, weight[0], weight[1], weight[2]);
    }
  }
}

std::string continued(const std::string& text) {
  return fmt::format("  {:<12}{}\n", "", text);
}

std::string describe_moves(const Remesh& remesh) {
  std::string text = fmt::format("  {:<12}{}{}", "sites",
                                 remesh.interrupted ? "INTERRUPTED, best state so far, after " : "",
                                 counted(remesh.steps.size(), "iteration", "iterations"));
  if (!remesh.steps.empty()) {
    const std::size_t first = remesh.steps.front().sites;
    const std::size_t last = remesh.steps.back().sites;
    text += first == last ? fmt::format(", {} sites", grouped(last))
                          : fmt::format(", from {} to {} sites", grouped(first), grouped(last));
  }
  return text + fmt::format("\n  {:<12}{:.8g}, {:.5g} of a regular hexagonal tiling{}\n", "energy",
                            remesh.energy, remesh.energy / remesh.energy_of_hexagonal_tiling,
                            remesh.vertices_fitted > 0 ? ", before the fit" : "");
}

// Of the input where it is a manifold, else of what it is cut apart into.
MeshTopology surface_topology(const Remesh& remesh) {
  MeshTopology topology;
  topology.parts = remesh.surface_parts;
  return topology;
}

// Why the remesh is no manifold of the input's topology; empty where it is one.
std::string find_flaw(const Remesh& remesh) {
  if (remesh.has_input_topology()) return "";
  const PartTopology surface = surface_topology(remesh).total();
  std::string flaw = fmt::format(
      "the input has {}, Euler characteristic {}, {}",
      counted(remesh.surface_parts.size(), "component", "components"), surface.euler_characteristic,
      counted(surface.boundary_loops, "boundary loop", "boundary loops"));
  if (remesh.violations_left > 0) {
    flaw += fmt::format("; {} where cells do not meet as they should",
                        counted(remesh.violations_left, "place", "places"));
  }
  return flaw;
}

std::string describe(const std::vector<ToleranceTrial>& trials, double diagonal) {
  if (trials.empty()) return "";
  std::string text;
  for (const ToleranceTrial& trial : trials) {
    text += fmt::format("{}{} {:.3g} %", text.empty() ? "" : ", ", grouped(trial.vertices),
                        100 * trial.distance / diagonal);
  }
  return fmt::format("  {:<12}vertices and largest distance, of the diagonal: {}\n", "tried", text);
}

std::string describe(const DistanceBounds& bounds, double diagonal) {
  return continued(fmt::format(
      "largest of both ways, certified: {:.6g} to {:.6g}, {:.4g} to {:.4g} %", bounds.lower,
      bounds.upper, 100 * bounds.lower / diagonal, 100 * bounds.upper / diagonal));
}

std::string describe_size(const Remesh& remesh) {
  const std::size_t vertices = remesh.mesh.vertex_count();
  const std::size_t wanted = remesh.vertices_asked_for;
  if (vertices > wanted) {
    return continued(counted(vertices - wanted, "vertex", "vertices") +
                     " more than asked for, which the topology needs");
  }
  if (vertices < wanted) {
    return continued(counted(wanted - vertices, "vertex", "vertices") + " fewer than asked for");
  }
  return "";
}

std::string describe(const Remesh& remesh) {
  const bool has_topology = remesh.has_input_topology();
  std::string text =
      fmt::format("  {:<12}{}, {}, {}, Euler characteristic {}, {}{}\n", "remesh",
                  counted(remesh.mesh.vertex_count(), "vertex", "vertices"),
                  counted(remesh.mesh.triangle_count(), "triangle", "triangles"),
                  counted(remesh.topology.parts.size(), "component", "components"),
                  remesh.topology.total().euler_characteristic, describe(remesh.topology),
                  has_topology && remesh.vertices_cut == 0 ? ", of the input's topology" : "");
  text += describe_size(remesh);
  if (!remesh.feature_edges.empty()) {
    text += continued(fmt::format("{} of length {:.6g} run along features of the input",
                                  counted(remesh.feature_edges.size(), "edge", "edges"),
                                  remesh.feature_length()));
  }
  if (remesh.small_feature_share > 0) {
    text += continued(fmt::format("{:.1f} % of the vertices for shorter edges at small features{}",
                                  100 * remesh.small_feature_share,
                                  remesh.small_features_limited ? ", which is the most" : ""));
  }
  if (remesh.subresolution_holes > 0) {
    text += continued(counted(remesh.subresolution_holes,
                              "hole smaller than a triangle is a missing triangle",
                              "holes smaller than a triangle are missing triangles"));
  }
  if (remesh.vertices_cut > 0) {
    text += continued(fmt::format("{}the input, which is no manifold and was cut apart at {}",
                                  has_topology ? "of the topology of " : "made from ",
                                  counted(remesh.vertices_cut, "vertex", "vertices")));
  }
  if (!remesh.self_intersections.empty()) {
    text += continued(describe_self_intersections(remesh.self_intersections.size()));
  }
  const std::string flaw = find_flaw(remesh);
  if (!flaw.empty()) {
    text += continued(std::string(remesh.is_manifold() ? "" : "NO MANIFOLD, ") +
                      "NOT OF THE INPUT'S TOPOLOGY: " + flaw);
  }
  return text;
}

std::string describe(const RemeshFigures& figures, double diagonal) {
  std::string text = describe(figures.quality);
  if (figures.in_metric) text += describe_in_metric(*figures.in_metric);
  if (figures.length_ratios) {
    const EdgeLengthRatios& ratios = *figures.length_ratios;
    text += fmt::format(
        "  {:<12}of what is asked for: median {:.3f}; 5 % below {:.3f}, 5 % above {:.3f}; {:.1f} % "
        "within a third\n",
        "lengths", ratios.median, ratios.fifth, ratios.ninety_fifth, 100 * ratios.share_in_third);
  }
  if (!figures.distance) return text;
  const DistanceFigures& distance = *figures.distance;
  text += fmt::format(
      "  {:<12}from the input to the remesh: mean {:.4g}, {:.4g} % of the diagonal; "
      "largest {:.4g}, {:.4g} %\n",
      "distance", distance.mean, 100 * distance.mean / diagonal, distance.largest,
      100 * distance.largest / diagonal);
  if (figures.volume_error) {
    text += continued(
        fmt::format("volume inside: {:+.3g} % of the input's", 100 * *figures.volume_error));
  }
  return text;
}

std::string describe_cost(const LoadedInput& loaded, const RemeshResult& result) {
  const TimedRemesh::Seconds& remesh = result.made.seconds;
  return fmt::format(
      "  {:<12}{:.2f} s: load {:.2f}, edges {:.2f}, prepare {:.2f}, move {:.2f}, assemble {:.2f}, "
      "judge {:.2f}, write {:.2f}; {:.0f} MB, {}\n",
      "time", result.total_seconds, loaded.seconds, loaded.edge_seconds, remesh.prepare,
      remesh.move, remesh.assemble, result.judge_seconds, result.write_seconds,
      static_cast<double>(result.peak_memory_bytes) * 1e-6,
      counted(result.workers.threads, "thread", "threads"));
}

std::string describe_files(const RemeshFiles& names) {
  std::string written(" ");
  written.append(names.remesh.name());
  for (const auto& file : other_files_of(names)) written.append(" ").append(file.string());
  std::string text = fmt::format("  {:<11}{}\n", "written", written);
  if (!names.picture.empty()) text += continued(names.picture.string());
  return text;
}

Json trials_part(const std::vector<ToleranceTrial>& trials) {
  Json part = Json::array();
  for (const ToleranceTrial& trial : trials) {
    part.push_back({{"vertices", trial.vertices},
                    {"distance", trial.distance},
                    {"distance_lower", trial.lower}});
  }
  return part;
}

Json remesh_part(const Remesh& remesh) {
  const std::string flaw = find_flaw(remesh);
  const auto vertices = static_cast<std::int64_t>(remesh.mesh.vertex_count());
  const auto wanted = static_cast<std::int64_t>(remesh.vertices_asked_for);
  return {{"vertices", vertices},
          {"triangles", remesh.mesh.triangle_count()},
          {"surplus_vertices", vertices - wanted},
          {"curve_vertices", remesh.curve_vertices},
          {"feature_edges", remesh.feature_edges.size()},
          {"feature_length", remesh.feature_length()},
          {"subresolution_holes", remesh.subresolution_holes},
          {"creases_left_out", remesh.creases_left_out},
          {"small_feature_share", remesh.small_feature_share},
          {"small_features_limited", remesh.small_features_limited},
          {"edges_flipped", remesh.edges_flipped},
          {"glides", remesh.glides},
          {"vertices_fitted", remesh.vertices_fitted},
          {"distance_before_fit", remesh.distance_before_fit},
          {"distance_after_fit", remesh.distance_after_fit},
          {"self_intersections", remesh.self_intersections.size()},
          {"is_manifold", remesh.is_manifold()},
          {"has_input_topology", remesh.has_input_topology()},
          {"input_is_manifold", remesh.vertices_cut == 0},
          {"input_vertices_cut", remesh.vertices_cut},
          {"flaw", flaw.empty() ? Json(nullptr) : Json(flaw)},
          {"topology", topology_part(remesh.topology)},
          {"input_topology", topology_part(surface_topology(remesh))},
          {"closed_ball_violations_left", remesh.violations_left}};
}

Json ratios_part(const RemeshFigures& figures) {
  if (!figures.length_ratios) return nullptr;
  const EdgeLengthRatios& ratios = *figures.length_ratios;
  return {{"percentile_5", ratios.fifth},
          {"median", ratios.median},
          {"percentile_95", ratios.ninety_fifth},
          {"within_a_third_percent", 100 * ratios.share_in_third}};
}

Json distance_part(const RemeshFigures& figures, double diagonal) {
  if (!figures.distance) return nullptr;
  Json part = {{"samples", figures.samples}};
  part.update(distance_part(*figures.distance, diagonal));
  return part;
}

Json seconds_part(const LoadedInput& loaded, const RemeshResult& result) {
  const TimedRemesh::Seconds& remesh = result.made.seconds;
  return {{"load", loaded.seconds},        {"edges", loaded.edge_seconds},
          {"prepare", remesh.prepare},     {"move", remesh.move},
          {"assemble", remesh.assemble},   {"judge", result.judge_seconds},
          {"write", result.write_seconds}, {"total", result.total_seconds}};
}

Json warnings_part(const Remesh& remesh) {
  Json part = Json::array();
  for (const RemeshWarning& warning : remesh.warnings) {
    part.push_back({{"kind", name_of(warning.flaw)}, {"text", warning.text}});
  }
  return part;
}

Json trace_part(const Remesh& remesh) {
  Json trace = Json::array();
  for (const SurfaceStep& step : remesh.steps) {
    trace.push_back({{"sites", step.sites},
                     {"mesh_vertices", step.mesh_vertices},
                     {"energy", step.energy},
                     {"seconds", step.seconds}});
  }
  return trace;
}

}  // namespace

void prepare_remesh_targets(RemeshFiles& names, const RemeshRequest& request, Console& console) {
  std::vector<std::filesystem::path> others = request.files();
  prepare_target(names.remesh, request.reading.format, others, console);
  others.push_back(names.remesh.file);
  for (const auto& file : {names.map, names.issues, names.report, names.picture, names.page}) {
    if (file.empty()) continue;
    check_target(file, others);
    others.push_back(file);
  }
}

FileGroup open_remesh_files(const RemeshFiles& names) {
  return {names.remesh, other_files_of(names)};
}

void write_remesh(const RemeshFiles& names, const RemeshResult& result, FileGroup& files) {
  const Remesh& remesh = result.made.remesh;
  write(files[0], format_to_write(names.remesh), remesh.mesh, result.properties);
  if (!names.map.empty()) write_map(remesh, files[1]);
  if (!names.issues.empty()) {
    write_issues(remesh.mesh, remesh.self_intersections, files[names.map.empty() ? 1 : 2]);
  }
}

std::string remesh_report(const RemeshRequest& request, const RemeshedInput& done) {
  const Input& input = done.loaded.input;
  const RemeshResult& result = done.result;
  const Remesh& remesh = result.made.remesh;
  Json report;
  report["command"] = "remesh";
  report["program"] = program_name();
  report["machine"] = machine_part();
  report["input"] = mesh_part(input);
  report["repairs"] = repairs_part(input.repairs);
  report["options"] = remesh_options_part(request, result.workers);
  report["interrupted"] = remesh.interrupted;
  report["warnings"] = warnings_part(remesh);
  report["trials"] = trials_part(result.trials);
  report["certified"] =
      result.bounds ? bounds_part(*result.bounds, input.facts.bounding_diagonal) : Json(nullptr);
  report["iterations"] = remesh.steps.size();
  report["energy"] = remesh.energy;
  report["energy_ratio_hexagonal"] = remesh.energy / remesh.energy_of_hexagonal_tiling;
  report["remesh"] = remesh_part(remesh);
  report["properties"] = properties_part(result.properties);
  report["quality"] = quality_part(result.figures.quality);
  report["quality_in_metric"] =
      result.figures.in_metric ? quality_part(*result.figures.in_metric) : Json(nullptr);
  report["edge_length_ratios"] = ratios_part(result.figures);
  report["input_to_remesh"] = distance_part(result.figures, input.facts.bounding_diagonal);
  report["remesh"]["volume_error_percent"] =
      result.figures.volume_error ? Json(100 * *result.figures.volume_error) : Json(nullptr);
  report["fingerprint"] = fingerprint_text(remesh.fingerprint);
  report["seconds"] = seconds_part(done.loaded, result);
  report["memory_estimate_bytes"] = result.memory_estimate;
  report["peak_memory_bytes"] = result.peak_memory_bytes;
  report["trace"] = trace_part(remesh);
  return json_text(report);
}

void write_remesh_report(const RemeshFiles& names, const RemeshRequest& request,
                         const RemeshedInput& done, FileGroup& files) {
  if (!names.report.empty()) files[other_files_of(names).size()].text(remesh_report(request, done));
  files.commit();
}

Json remesh_options_part(const RemeshRequest& request, const RemeshWorkers& workers) {
  const RemeshOptions& options = request.options;
  const auto or_null = [](auto value) { return value > 0 ? Json(value) : Json(nullptr); };
  const bool varies = !request.lengths_file.empty() || !request.densities_file.empty() ||
                      options.sizing.adapt > 0 || options.sizing.equal_error ||
                      !request.field.vfield.empty();
  return {{"vertices", or_null(options.vertex_count)},
          {"edge_length", or_null(options.edge_length)},
          {"tolerance", or_null(request.tolerance)},
          {"tolerance_is_percentage", request.is_percentage},
          {"sizing", request.lengths_file.string()},
          {"density", request.densities_file.string()},
          {"adapt", options.sizing.adapt},
          {"equal_error", options.sizing.equal_error},
          {"growth", varies ? Json(options.sizing.growth) : Json(nullptr)},
          {"vfield", request.field.vfield.string()},
          {"repair", request.repair.has_value()},
          {"fill_holes", fill_holes_part(request.repair)},
          {"features", name_of_creases(options.features)},
          {"small_features", options.features.small},
          {"feature_edges", request.edges_file.string()},
          {"feature_labels", request.labels},
          {"fixed", request.fixed_file.string()},
          {"fit", options.fit},
          {"drop", !request.carries_properties},
          {"weld", request.reading.weld},
          {"engine", name_of(engine_names, workers.engine)},
          {"threads", workers.threads},
          {"backend", backend_part(workers.engine, workers.backend)}};
}

void write_remesh_picture(const std::filesystem::path& file, const PictureLook& look,
                          const RemeshedInput& done, const SurfaceColours& colours,
                          Executor& executor) {
  const Picture picture(done.result.made.remesh.mesh, done.loaded.input.mesh(), look.view,
                        look.size, 1, false, executor);
  const Canvas canvas = paint_mesh(picture.scene(), executor, colours);
  const std::array<PanelImage, 1> panels = {{{to_pixels(picture.scene(), canvas, executor), ""}}};
  picture.write(file, panels);
}

std::string describe(const RemeshFiles& names, const RemeshedInput& done) {
  const RemeshResult& result = done.result;
  const Remesh& remesh = result.made.remesh;
  const Input& input = done.loaded.input;
  return fmt::format("{}\n{}", input.file.string(),
                     describe(input.loaded, input.facts, HandledBy::surface)) +
         (input.repairs ? describe(*input.repairs) : "") +
         describe(result.trials, input.facts.bounding_diagonal) + describe_moves(remesh) +
         describe(remesh) + describe(result.properties) +
         describe(result.figures, input.facts.bounding_diagonal) +
         (result.bounds ? describe(*result.bounds, input.facts.bounding_diagonal) : "") +
         fmt::format("  {:<12}{}\n", "fingerprint", fingerprint_text(remesh.fingerprint)) +
         describe_cost(done.loaded, result) + describe_files(names);
}

}  // namespace geolloyd
