#include "tools/report/dual_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "tools/report/report_parts.h"
#include "tools/words/facts_text.h"

namespace geolloyd {
namespace {

std::string describe(ViolationKind kind) {
  switch (kind) {
    case ViolationKind::region:
      return "is no disc";
    case ViolationKind::contact:
      return "meet in several places";
    case ViolationKind::triple:
      return "meet at several corners";
    case ViolationKind::isolation:
      return "touches no corner of three";
  }
  return "";
}

std::string describe(const ClosedBallViolation& violation) {
  std::string regions;
  std::size_t count = 0;
  for (const RegionId r : violation.regions) {
    if (r == no_id) continue;
    regions += (count++ == 0 ? " " : ", ") + std::to_string(r);
  }
  return (count == 1 ? "region" : "regions") + regions + " " + describe(violation.kind);
}

std::string describe(ViolationsLeft why) {
  switch (why) {
    case ViolationsLeft::none:
      return "";
    case ViolationsLeft::not_asked:
      return ", and seeds were not to be added (--no-manifold)";
    case ViolationsLeft::stopped:
      return ", and the work was interrupted";
    case ViolationsLeft::bounded:
      return ", and no more seeds are added to an input that is no manifold";
    case ViolationsLeft::no_room:
      return ", and no further seed there helps: use a finer mesh";
  }
  return "";
}

std::string describe_input(const GraphDual& dual) {
  return "the input is no manifold: " + describe(dual.input_topology);
}

// Why the dual is no manifold of the input's topology; empty where it is one.
std::string find_flaw(const GraphDual& dual) {
  if (dual.is_manifold() && dual.has_input_topology() && dual.violations_left.empty()) {
    return "";
  }
  const auto& left = dual.violations_left;
  const auto first = std::find_if(left.begin(), left.end(),
                                  [](const ClosedBallViolation& v) { return !v.is_of_input; });
  if (first != left.end()) return describe(*first) + describe(dual.why_left);
  if (!dual.input_topology.is_manifold()) return describe_input(dual);
  return "its topology differs from the input's";
}

std::string line(const std::string& text) {
  return fmt::format("  {:<12}{}\n", "", text);
}

std::string line_if(std::size_t count, const char* singular, const char* plural) {
  return count == 0 ? "" : line(counted(count, singular, plural));
}

Json violations_part(std::span<const ClosedBallViolation> violations) {
  return {{"regions_not_discs", count(violations, ViolationKind::region)},
          {"contacts_not_curves", count(violations, ViolationKind::contact)},
          {"triples_with_several_corners", count(violations, ViolationKind::triple)},
          {"regions_without_corner", count(violations, ViolationKind::isolation)},
          {"of_the_input", std::count_if(violations.begin(), violations.end(),
                                         [](const auto& v) { return v.is_of_input; })}};
}

}  // namespace

std::string describe(const GraphDual& dual) {
  std::string text =
      fmt::format("  {:<12}{}, {}, Euler characteristic {}, {}\n", "dual",
                  counted(dual.mesh.vertex_count(), "vertex", "vertices"),
                  counted(dual.mesh.triangle_count(), "triangle", "triangles"),
                  dual.topology.total().euler_characteristic, describe(dual.topology));
  if (dual.seeds_added > 0) {
    text += line(counted(dual.seeds_added, "seed", "seeds") +
                 " added where regions did not meet as they should");
  }
  if (dual.interrupted) text += line("INTERRUPTED while seeds were added");
  text += line_if(dual.flipped, "triangle faces away from the surface",
                  "triangles face away from the surface");
  text += line_if(dual.flat, "triangle without area", "triangles without area");
  text += line_if(dual.folds, "edge folded by more than 150 degrees",
                  "edges folded by more than 150 degrees");
  text += line_if(dual.self_intersections.size(), "pair of triangles crosses",
                  "pairs of triangles cross");
  const std::string flaw = find_flaw(dual);
  if (!flaw.empty()) {
    text += line(std::string(dual.is_manifold() ? "a manifold" : "NO MANIFOLD") +
                 (dual.has_input_topology() ? ", of the input's topology: "
                                            : ", NOT OF THE INPUT'S TOPOLOGY: ") +
                 flaw);
  }
  if (!dual.input_topology.is_manifold() && flaw != describe_input(dual)) {
    text += line(describe_input(dual));
  }
  return text;
}

std::string describe(const std::optional<QuadPairs>& quads) {
  if (!quads) return "";
  const std::size_t triangles = quads->faces.size() - quads->quads;
  std::string text = counted(quads->quads, "quadrilateral", "quadrilaterals") + " and " +
                     counted(triangles, "triangle", "triangles");
  if (quads->quads > 0) {
    text += fmt::format("; corners of {:.0f} to {:.0f} degrees", quads->smallest_angle,
                        quads->largest_angle);
  }
  return line(text);
}

Json quads_part(const std::optional<QuadPairs>& quads) {
  if (!quads) return nullptr;
  return {{"quadrilaterals", quads->quads},
          {"triangles", quads->faces.size() - quads->quads},
          {"smallest_angle", quads->quads > 0 ? Json(quads->smallest_angle) : Json(nullptr)},
          {"largest_angle", quads->quads > 0 ? Json(quads->largest_angle) : Json(nullptr)}};
}

Json dual_part(const GraphDual& dual) {
  const std::string flaw = find_flaw(dual);
  return {{"vertices", dual.mesh.vertex_count()},
          {"triangles", dual.mesh.triangle_count()},
          {"seeds_added", dual.seeds_added},
          {"interrupted", dual.interrupted},
          {"reassigned_points", dual.reassigned_points},
          {"is_manifold", dual.is_manifold()},
          {"has_input_topology", dual.has_input_topology()},
          {"input_is_manifold", dual.input_topology.is_manifold()},
          {"flaw", flaw.empty() ? Json(nullptr) : Json(flaw)},
          {"topology", topology_part(dual.topology)},
          {"input_topology", topology_part(dual.input_topology)},
          {"repeated_triangles", dual.repeated},
          {"back_to_back_triangles", dual.back_to_back},
          {"flipped_triangles", dual.flipped},
          {"triangles_without_area", dual.flat},
          {"folded_edges", dual.folds},
          {"self_intersections", dual.self_intersections.size()},
          {"closed_ball_violations_found", violations_part(dual.violations_found)},
          {"closed_ball_violations_left", violations_part(dual.violations_left)}};
}

}  // namespace geolloyd
