#include "tools/words/facts_text.h"

#include <fmt/format.h>

#include "core/mesh/properties.h"

namespace geolloyd {
namespace {

// A line where there is something to say.
std::string finding(std::size_t count, const std::string& what) {
  return count == 0 ? "" : fmt::format("  {:<12}{} {}\n", "found", grouped(count), what);
}

}  // namespace

std::string grouped(std::uint64_t number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string counted(std::uint64_t number, const char* singular, const char* plural) {
  return grouped(number) + " " + (number == 1 ? singular : plural);
}

std::string describe(const LoadedMesh& input, const MeshFacts& facts, HandledBy handled_by) {
  std::string text = fmt::format(
      "  {:<12}{}: {}, {}, {}\n"
      "  {:<12}{}, Euler characteristic {}, {}, area {:.6g}, diagonal {:.6g}\n",
      "mesh", input.format, counted(facts.vertices, "vertex", "vertices"),
      counted(facts.edges, "edge", "edges"), counted(facts.triangles, "triangle", "triangles"), "",
      counted(facts.components, "component", "components"), facts.euler_characteristic,
      facts.boundary_edges == 0 ? "closed"
                                : counted(facts.boundary_edges, "boundary edge", "boundary edges"),
      facts.area, facts.bounding_diagonal);
  const bool in_graph = handled_by == HandledBy::graph;
  const auto found = [&](std::size_t count, std::string what, const char* by_graph,
                         const char* by_surface) {
    text += finding(count, what.append(in_graph ? by_graph : by_surface));
  };
  text += finding(input.polygon_count, "polygons: split into triangles");
  text += finding(input.welded_corners, "repeated corners: welded");
  found(facts.unreferenced_vertices, "vertices of no triangle", ": get no region", ": left out");
  found(facts.repeated_vertex_triangles, "triangles naming a vertex twice", ": get no region",
        ": left out");
  found(facts.zero_area_triangles, "triangles without area", ": have no mass", "");
  found(facts.duplicate_triangles, "duplicate triangles", ": mass counted once", ": left out");
  found(facts.non_manifold_edges, "non-manifold edges", ": all their triangles connected",
        ": cut apart");
  found(facts.inconsistent_edges, "edges between opposite orientations", ": connected",
        ": connected");
  found(facts.zero_length_edges, "edges without length", ": one tick long", "");
  return text;
}

std::string describe(const Properties& carried) {
  std::string names;
  const auto add = [&](const std::vector<Property>& properties, const char* of) {
    if (properties.empty()) return;
    names += fmt::format("{}{} of {}", names.empty() ? "" : "; ", list_names(properties), of);
  };
  add(carried.of_vertices, "vertices");
  add(carried.of_triangles, "triangles");
  std::string text;
  if (!names.empty()) text += fmt::format("  {:<12}{}\n", "carried", names);
  for (const std::string& line : carried.left_out) {
    text += fmt::format("  {:<12}{}\n", "left out", line);
  }
  return text;
}

std::string describe(const MeshTopology& topology) {
  std::string text = counted(topology.total().boundary_loops, "boundary loop", "boundary loops");
  if (topology.is_manifold()) return text + ", manifold";
  if (topology.non_manifold_edges > 0) {
    text += ", " + counted(topology.non_manifold_edges, "edge of more than two triangles",
                           "edges of more than two triangles");
  }
  if (topology.non_manifold_vertices > 0) {
    text += ", " + counted(topology.non_manifold_vertices, "vertex where surfaces touch",
                           "vertices where surfaces touch");
  }
  return text;
}

}  // namespace geolloyd
