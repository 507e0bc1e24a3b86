#include "tools/report/remesh_output.h"

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

std::string describe_input(const GraphRemesh& remesh) {
  return "the input is no manifold: " + describe(remesh.input_topology);
}

// Why the remesh is no manifold of the input's topology; empty where it is one.
std::string find_flaw(const GraphRemesh& remesh) {
  if (remesh.is_manifold() && remesh.has_input_topology() && remesh.violations_left.empty()) {
    return "";
  }
  const auto& left = remesh.violations_left;
  const auto first = std::find_if(left.begin(), left.end(),
                                  [](const ClosedBallViolation& v) { return !v.is_of_input; });
  if (first != left.end()) return describe(*first) + describe(remesh.why_left);
  if (!remesh.input_topology.is_manifold()) return describe_input(remesh);
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

std::string describe(const GraphRemesh& remesh) {
  std::string text =
      fmt::format("  {:<12}{}, {}, Euler characteristic {}, {}\n", "remesh",
                  counted(remesh.mesh.vertex_count(), "vertex", "vertices"),
                  counted(remesh.mesh.triangle_count(), "triangle", "triangles"),
                  remesh.topology.total().euler_characteristic, describe(remesh.topology));
  if (remesh.seeds_added > 0) {
    text += line(counted(remesh.seeds_added, "seed", "seeds") +
                 " added where regions did not meet as they should");
  }
  if (remesh.interrupted) text += line("INTERRUPTED while seeds were added");
  text += line_if(remesh.flipped, "triangle faces away from the surface",
                  "triangles face away from the surface");
  text += line_if(remesh.flat, "triangle without area", "triangles without area");
  text += line_if(remesh.folds, "edge folded by more than 150 degrees",
                  "edges folded by more than 150 degrees");
  const std::string flaw = find_flaw(remesh);
  if (!flaw.empty()) {
    text += line(std::string(remesh.is_manifold() ? "a manifold" : "NO MANIFOLD") +
                 (remesh.has_input_topology() ? ", of the input's topology: "
                                              : ", NOT OF THE INPUT'S TOPOLOGY: ") +
                 flaw);
  }
  if (!remesh.input_topology.is_manifold() && flaw != describe_input(remesh)) {
    text += line(describe_input(remesh));
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

Json remesh_part(const GraphRemesh& remesh) {
  const std::string flaw = find_flaw(remesh);
  return {{"vertices", remesh.mesh.vertex_count()},
          {"triangles", remesh.mesh.triangle_count()},
          {"seeds_added", remesh.seeds_added},
          {"interrupted", remesh.interrupted},
          {"reassigned_points", remesh.reassigned_points},
          {"is_manifold", remesh.is_manifold()},
          {"has_input_topology", remesh.has_input_topology()},
          {"input_is_manifold", remesh.input_topology.is_manifold()},
          {"flaw", flaw.empty() ? Json(nullptr) : Json(flaw)},
          {"topology", topology_part(remesh.topology)},
          {"input_topology", topology_part(remesh.input_topology)},
          {"repeated_triangles", remesh.repeated},
          {"back_to_back_triangles", remesh.back_to_back},
          {"flipped_triangles", remesh.flipped},
          {"triangles_without_area", remesh.flat},
          {"folded_edges", remesh.folds},
          {"closed_ball_violations_found", violations_part(remesh.violations_found)},
          {"closed_ball_violations_left", violations_part(remesh.violations_left)}};
}

}  // namespace geolloyd
