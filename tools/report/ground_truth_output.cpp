#include "tools/report/ground_truth_output.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "core/text/file_writer.h"
#include "tools/files/csv.h"
#include "tools/files/file_group.h"
#include "tools/words/facts_text.h"

namespace geolloyd {
namespace {

constexpr std::array<const char*, 3> ground_truth_names = {
    "ground-truth-regions.csv", "ground-truth-seeds.csv", "ground-truth.json"};

Json statistics_part(const Statistics& values) {
  return {{"mean", values.mean()}, {"max", values.max()}};
}

void write_regions(const MeshGraph& mesh_graph, const JudgedPartition& judged, FileWriter& out) {
  out.text("input_id,kind,region,ground_truth\n");
  const std::vector<NodeId>& node_of = mesh_graph.node_of;
  for (std::uint32_t id = 0; id < node_of.size(); ++id) {
    const std::string_view kind = kind_of(mesh_graph, id);
    const NodeId v = node_of[id];
    if (v == no_id || judged.truth.region[v] == no_id) {
      write_row(out, id, kind, "-1", "-1");
    } else {
      write_row(out, id, kind, region_of(judged.partition.key[v]), judged.truth.region[v]);
    }
  }
}

void write_seeds(const PreparedInput& start, const GroundTruth& truth, FileWriter& out) {
  out.text(
      "input_id,kind,x,y,z,area,centroid_x,centroid_y,centroid_z,surface_x,surface_y,surface_z,"
      "distance\n");
  for (std::size_t r = 0; r < truth.centroid.size(); ++r) {
    const std::uint32_t id = start.mesh_graph.input_id[start.seeds[r]];
    const Vec3& p = start.mesh_graph.position[start.seeds[r]];
    const Vec3& c = truth.centroid[r];
    const Vec3& s = truth.surface_centroid[r];
    write_row(out, id, kind_of(start.mesh_graph, id), p.x(), p.y(), p.z(), truth.area[r], c.x(),
              c.y(), c.z(), s.x(), s.y(), s.z(), truth.seed_distance[r]);
  }
}

Json result_of(const RunRequest& request, const PreparedInput& start,
               const JudgedPartition& judged) {
  Json result = begin_result("ground-truth", start.input);
  RelaxationOptions options;
  options.greedy = greedy_mode({}, !request.seed_file.path.empty(), request.seeds.init);
  result["options"] = options_part(request, options, start.seeds.size());
  result["graph"] = graph_part(start.mesh_graph.graph, start.components);
  result["seed_fit"] = seed_fit_part(start.seed_fit);
  result["ground_truth"] = ground_truth_part(judged.truth);
  result["threads"] = judged.threads;
  result["seconds"] = judged.seconds;
  return result;
}

}  // namespace

std::string describe(const GroundTruth& truth) {
  const Statistics& edges = truth.distance_in_edges;
  const Statistics& radii = truth.distance_in_radii;
  std::string text =
      fmt::format("  {:<12}{:.2f}% of nodes, {:.2f}% of area, with the ground truth\n", "agreement",
                  100 * truth.node_agreement, 100 * truth.area_agreement);
  text += fmt::format(
      "  {:<12}of the ground truth {:.3g} edges, {:.3g}% of the radius, from the seeds; at most "
      "{:.3g}, {:.3g}%\n",
      "centroids", edges.mean(), 100 * radii.mean(), edges.max(), 100 * radii.max());
  text += fmt::format("  {:<12}energy {:.8g}, of the ground truth {:.8g}", "Euclidean",
                      truth.graph_energy, truth.energy);
  if (truth.hexagonal > 0) {
    text += fmt::format(": {:.5g} and {:.5g} of a regular hexagonal tiling",
                        truth.graph_energy / truth.hexagonal, truth.energy / truth.hexagonal);
  }
  return text + "\n";
}

Json ground_truth_part(const GroundTruth& truth) {
  return {{"node_agreement", truth.node_agreement},
          {"area_agreement", truth.area_agreement},
          {"unreached_nodes", truth.unreached_nodes},
          {"distance_in_edges", statistics_part(truth.distance_in_edges)},
          {"distance_in_radii", statistics_part(truth.distance_in_radii)},
          {"energy", truth.energy},
          {"energy_ratio_hexagonal", truth.energy / truth.hexagonal},
          {"graph_energy", truth.graph_energy},
          {"graph_energy_ratio_hexagonal", truth.graph_energy / truth.hexagonal}};
}

MadeFolders prepare_ground_truth_output(const std::filesystem::path& folder,
                                        const RunRequest& request) {
  if (folder.empty()) return {};
  return prepare_folder(folder, ground_truth_names, request.files());
}

std::string write_ground_truth(const std::filesystem::path& folder, const RunRequest& request,
                               const PreparedInput& start, const JudgedPartition& judged) {
  std::string report = json_text(result_of(request, start, judged));
  if (!folder.empty()) {
    FileGroup files(folder, ground_truth_names);
    write_regions(start.mesh_graph, judged, files[0]);
    write_seeds(start, judged.truth, files[1]);
    files[2].text(report);
    files.commit();
  }
  return report;
}

}  // namespace geolloyd
