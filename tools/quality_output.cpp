#include "tools/quality_output.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/facts_text.h"
#include "tools/report_parts.h"
#include "tools/text_table.h"

namespace geolloyd {
namespace {

// Of the original's bounding-box diagonal.
double percent(const Likeness& likeness, double distance) {
  return 100 * distance / likeness.original.facts.bounding_diagonal;
}

std::int64_t difference(std::size_t a, std::size_t b) {
  return static_cast<std::int64_t>(a) - static_cast<std::int64_t>(b);
}

std::string share_text(double share) {
  return std::isnan(share) ? "none" : fmt::format("{:.2f} %", 100 * share);
}

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

std::string distance_table(const Likeness& likeness) {
  TextTable table({"distance", "mean", "%", "RMS", "%", "Hausdorff", "%"}, 1);
  const auto add = [&](const char* name, const DistanceFigures& figures) {
    std::vector<std::string> row = {name};
    for (const double distance : {figures.mean, figures.rms, figures.largest}) {
      row.push_back(fmt::format("{:.4g}", distance));
      row.push_back(fmt::format("{:.4g}", percent(likeness, distance)));
    }
    table.add(std::move(row));
  };
  add("remesh to original", likeness.distance.from_first);
  add("original to remesh", likeness.distance.from_second);
  add("the larger", likeness.distance.two_sided());
  return table.text();
}

std::string describe(const Likeness& likeness, const MeshFacts& remesh) {
  const MeshFacts& original = likeness.original.facts;
  return fmt::format(
      "\n{}\n{}"
      "  {:<12}Euler characteristic {:+}, components {:+}, boundary edges {:+} in the remesh\n"
      "  {:<12}of the remesh's vertices as sites: {:.5g} of a regular hexagonal tiling\n"
      "\n{}"
      "  {} samples on each and all vertices; %: of the original's bounding-box diagonal\n",
      likeness.original.file.string(), describe(likeness.original.input, original), "difference",
      remesh.euler_characteristic - original.euler_characteristic,
      difference(remesh.components, original.components),
      difference(remesh.boundary_edges, original.boundary_edges), "energy",
      likeness.energy / likeness.hexagonal, distance_table(likeness), grouped(likeness.samples));
}

Json quality_part(const MeshQuality& q) {
  return {{"smallest_angle", q.smallest_angle},   {"mean_smallest_angle", q.mean_smallest_angle},
          {"share_under_30", q.share_under_30},   {"smallest_quality", q.smallest_quality},
          {"mean_quality", q.mean_quality},       {"inner_vertices", q.inner_vertices},
          {"share_valence_6", q.share_valence_6}, {"share_valence_5_to_7", q.share_valence_5_to_7}};
}

Json figures_part(const Likeness& likeness, const DistanceFigures& figures) {
  return {{"mean", figures.mean},
          {"rms", figures.rms},
          {"hausdorff", figures.largest},
          {"mean_percent", percent(likeness, figures.mean)},
          {"rms_percent", percent(likeness, figures.rms)},
          {"hausdorff_percent", percent(likeness, figures.largest)}};
}

Json likeness_part(const Likeness& likeness, const MeshFacts& remesh) {
  const MeshFacts& original = likeness.original.facts;
  return {{"samples", likeness.samples},
          {"remesh_to_original", figures_part(likeness, likeness.distance.from_first)},
          {"original_to_remesh", figures_part(likeness, likeness.distance.from_second)},
          {"two_sided", figures_part(likeness, likeness.distance.two_sided())},
          {"energy", likeness.energy},
          {"energy_ratio_hexagonal", likeness.energy / likeness.hexagonal},
          {"euler_characteristic_difference",
           remesh.euler_characteristic - original.euler_characteristic},
          {"components_difference", difference(remesh.components, original.components)}};
}

}  // namespace

std::string quality_text(const QualityRecord& record) {
  const MeshFile& remesh = record.remesh;
  std::string text =
      remesh.file.string() + "\n" + describe(remesh.input, remesh.facts) + describe(record.quality);
  if (record.likeness) text += describe(*record.likeness, remesh.facts);
  return text;
}

std::string quality_report(const QualityRecord& record) {
  const MeshFile& remesh = record.remesh;
  Json report;
  report["program"] = "geolloyd " GEOLLOYD_VERSION;
  report["remesh"] = mesh_part(remesh.file, remesh.input, remesh.facts);
  report["quality"] = quality_part(record.quality);
  if (record.likeness) {
    const MeshFile& original = record.likeness->original;
    report["original"] = mesh_part(original.file, original.input, original.facts);
    report["likeness"] = likeness_part(*record.likeness, remesh.facts);
  }
  return json_text(report);
}

}  // namespace geolloyd
