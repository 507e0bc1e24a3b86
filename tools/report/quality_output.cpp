#include "tools/report/quality_output.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/report/report_parts.h"
#include "tools/system/build_facts.h"
#include "tools/words/facts_text.h"
#include "tools/words/text_table.h"

namespace geolloyd {
namespace {

std::int64_t difference(std::size_t a, std::size_t b) {
  return static_cast<std::int64_t>(a) - static_cast<std::int64_t>(b);
}

std::string share_text(double share) {
  return std::isnan(share) ? "none" : fmt::format("{:.2f} %", 100 * share);
}

// Percent are of `diagonal`.
std::string distance_table(const Likeness& likeness, double diagonal) {
  TextTable table({"distance", "mean", "%", "RMS", "%", "Hausdorff", "%"}, 1);
  const auto add = [&](const char* name, const DistanceFigures& figures) {
    std::vector<std::string> row = {name};
    for (const double distance : {figures.mean, figures.rms, figures.largest}) {
      row.push_back(fmt::format("{:.4g}", distance));
      row.push_back(fmt::format("{:.4g}", 100 * distance / diagonal));
    }
    table.add(std::move(row));
  };
  add("remesh to original", likeness.distance.from_first);
  add("original to remesh", likeness.distance.from_second);
  add("the larger", likeness.distance.two_sided());
  return table.text();
}

std::string describe(const SurfaceDistanceBounds& bounds, double diagonal) {
  const auto interval = [&](const DistanceBounds& b) {
    return fmt::format("[{:.7g}, {:.7g}], [{:.5g}, {:.5g}] %", b.lower, b.upper,
                       100 * b.lower / diagonal, 100 * b.upper / diagonal);
  };
  return fmt::format(
      "  Hausdorff, certified: remesh to original {}\n"
      "                        original to remesh {}\n"
      "                        the larger         {}\n",
      interval(bounds.from_first), interval(bounds.from_second), interval(bounds.two_sided()));
}

std::string describe_file(const JudgedMesh& mesh) {
  return fmt::format("{}\n{}  {:<12}{}\n", mesh.input.file.string(),
                     describe(mesh.input.loaded, mesh.input.facts), "topology",
                     describe(mesh.topology));
}

std::string describe(const Likeness& likeness, const JudgedMesh& remesh,
                     const JudgedMesh& original) {
  return fmt::format(
      "\n{}"
      "  {:<12}Euler characteristic {:+}, components {:+}, boundary loops {:+} in the remesh\n"
      "  {:<12}of the vertices' closest points on the original as sites: {:.5g} of a regular "
      "hexagonal tiling\n"
      "\n{}"
      "  {} samples on each and all vertices; %: of the original's bounding-box diagonal\n",
      describe_file(original), "difference",
      remesh.input.facts.euler_characteristic - original.input.facts.euler_characteristic,
      difference(remesh.input.facts.components, original.input.facts.components),
      difference(remesh.topology.total().boundary_loops, original.topology.total().boundary_loops),
      "energy", likeness.energy / likeness.hexagonal,
      distance_table(likeness, original.input.facts.bounding_diagonal), grouped(likeness.samples));
}

std::string describe(const MetricQuality& judged) {
  return describe_in_metric(judged.quality) +
         fmt::format(
             "  {:<12}edges: mean {:.4g}; of the mean: 5 % below {:.3f}, 5 % above {:.3f}, {:.1f} "
             "% within a third\n"
             "  {:<12}energy: {:.5g} of a regular hexagonal tiling\n",
             "", judged.mean_length, judged.lengths.fifth, judged.lengths.ninety_fifth,
             100 * judged.lengths.share_in_third, "", judged.energy_ratio);
}

Json metric_part(const MetricQuality& judged) {
  return {{"quality", quality_part(judged.quality)},
          {"mean_edge_length", judged.mean_length},
          {"edge_lengths_over_mean",
           {{"percentile_5", judged.lengths.fifth},
            {"median", judged.lengths.median},
            {"percentile_95", judged.lengths.ninety_fifth},
            {"within_a_third_percent", 100 * judged.lengths.share_in_third}}},
          {"energy_ratio_hexagonal", judged.energy_ratio}};
}

Json likeness_part(const Likeness& likeness, double diagonal) {
  const auto part = [&](const DistanceFigures& figures) {
    return distance_part(figures, diagonal);
  };
  return {{"samples", likeness.samples},
          {"remesh_to_original", part(likeness.distance.from_first)},
          {"original_to_remesh", part(likeness.distance.from_second)},
          {"two_sided", part(likeness.distance.two_sided())},
          {"energy", likeness.energy},
          {"energy_ratio_hexagonal", likeness.energy / likeness.hexagonal}};
}

void add_bounds(const SurfaceDistanceBounds& bounds, double diagonal, Json& likeness) {
  likeness["remesh_to_original"].update(bounds_part(bounds.from_first, diagonal));
  likeness["original_to_remesh"].update(bounds_part(bounds.from_second, diagonal));
  likeness["two_sided"].update(bounds_part(bounds.two_sided(), diagonal));
}

}  // namespace

std::string describe(const MeshQuality& q) {
  return fmt::format(
      "  {:<12}smallest {:.4g} degrees, mean of each triangle's smallest {:.4g}, "
      "under 30 degrees {}\n"
      "  {:<12}smallest {:.4g}, mean {:.4g}\n"
      "  {:<12}6: {}, 5 to 7: {}, of {}\n",
      "angle", q.smallest_angle, q.mean_smallest_angle, share_text(q.share_under_30), "quality Q",
      q.smallest_quality, q.mean_quality, "valence", share_text(q.share_valence_6),
      share_text(q.share_valence_5_to_7),
      counted(q.inner_vertices, "inner vertex", "inner vertices"));
}

std::string describe_in_metric(const MeshQuality& q) {
  return fmt::format(
      "  {:<12}angles: smallest {:.4g} degrees, mean of each triangle's smallest {:.4g}, "
      "under 30 degrees {}\n"
      "  {:<12}quality Q: smallest {:.4g}, mean {:.4g}\n",
      "in metric", q.smallest_angle, q.mean_smallest_angle, share_text(q.share_under_30), "",
      q.smallest_quality, q.mean_quality);
}

Json quality_part(const MeshQuality& q) {
  return {{"smallest_angle", q.smallest_angle},
          {"mean_smallest_angle", q.mean_smallest_angle},
          {"share_under_30", q.share_under_30},
          {"share_obtuse", q.share_obtuse},
          {"smallest_quality", q.smallest_quality},
          {"mean_quality", q.mean_quality},
          {"inner_vertices", q.inner_vertices},
          {"share_valence_6", q.share_valence_6},
          {"share_valence_5_to_7", q.share_valence_5_to_7}};
}

Json distance_part(const DistanceFigures& figures, double diagonal) {
  return {{"mean", figures.mean},
          {"rms", figures.rms},
          {"hausdorff", figures.largest},
          {"mean_percent", 100 * figures.mean / diagonal},
          {"rms_percent", 100 * figures.rms / diagonal},
          {"hausdorff_percent", 100 * figures.largest / diagonal}};
}

Json bounds_part(const DistanceBounds& bounds, double diagonal) {
  return {{"hausdorff_lower", bounds.lower},
          {"hausdorff_upper", bounds.upper},
          {"hausdorff_lower_percent", 100 * bounds.lower / diagonal},
          {"hausdorff_upper_percent", 100 * bounds.upper / diagonal}};
}

std::string quality_text(const QualityRecord& record) {
  const JudgedMesh& remesh = record.remesh;
  std::string text = describe_file(remesh);
  if (!record.self_intersections.empty()) {
    text += fmt::format("  {:<12}{}\n", "",
                        describe_self_intersections(record.self_intersections.size()));
  }
  text += describe(record.quality);
  text += fmt::format("  {:<12}{} of the triangles\n", "obtuse",
                      share_text(record.quality.share_obtuse));
  if (record.in_metric) text += describe(*record.in_metric);
  if (record.likeness) text += describe(*record.likeness, remesh, *record.original);
  if (record.bounds) {
    text += describe(*record.bounds, record.original->input.facts.bounding_diagonal);
  }
  return text;
}

std::string quality_report(const QualityRecord& record) {
  const JudgedMesh& remesh = record.remesh;
  Json report;
  report["program"] = program_name();
  report["remesh"] = mesh_part(remesh.input);
  report["topology"] = topology_part(remesh.topology);
  report["self_intersections"] = record.self_intersections.size();
  report["quality"] = quality_part(record.quality);
  if (record.in_metric) report["in_metric"] = metric_part(*record.in_metric);
  if (record.likeness) {
    const JudgedMesh& original = *record.original;
    report["original"] = mesh_part(original.input);
    report["original_topology"] = topology_part(original.topology);
    report["likeness"] = likeness_part(*record.likeness, original.input.facts.bounding_diagonal);
    if (record.bounds) {
      add_bounds(*record.bounds, original.input.facts.bounding_diagonal, report["likeness"]);
    }
  }
  return json_text(report);
}

}  // namespace geolloyd
