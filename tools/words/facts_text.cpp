#include "tools/words/facts_text.h"

#include <fmt/format.h>

#include "core/properties/properties.h"

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

std::string describe_reading(const LoadedMesh& input) {
  return finding(input.polygon_count, "polygons: split into triangles") +
         finding(input.welded_corners, "repeated corners: welded") +
         finding(input.welded_vertices, "vertices in the places of others: welded");
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
  const auto found = [&](std::size_t count, std::string what, const char* by_graph,
                         const char* by_surface) {
    what += handled_by == HandledBy::graph     ? by_graph
            : handled_by == HandledBy::surface ? by_surface
                                               : "";
    text += finding(count, what);
  };
  text += describe_reading(input);
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

std::string describe(const Repairs& repairs) {
  std::string text;
  const char* what = "repaired";
  const auto tell = [&](std::size_t count, const char* singular, const char* plural) {
    if (count > 0) text += fmt::format("  {:<12}{}\n", what, counted(count, singular, plural));
  };
  tell(repairs.unused_vertices, "vertex of no triangle: left out",
       "vertices of no triangle: left out");
  tell(repairs.repeated_vertex_triangles, "triangle naming a vertex twice: left out",
       "triangles naming a vertex twice: left out");
  tell(repairs.duplicate_triangles, "duplicate triangle: left out",
       "duplicate triangles: left out");
  tell(repairs.vertices_cut, "vertex cut apart, where surfaces touch",
       "vertices cut apart, where surfaces touch");
  tell(repairs.vertices_merged, "vertex merged with one in the same place",
       "vertices merged with others in the same place");
  tell(repairs.slivers_removed, "triangle without area: removed",
       "triangles without area: removed");
  tell(repairs.triangles_turned, "triangle turned, to the orientation of its neighbours",
       "triangles turned, to the orientation of their neighbours");
  if (repairs.holes_filled > 0) {
    text += fmt::format("  {:<12}{} filled with {}\n", "repaired",
                        counted(repairs.holes_filled, "hole", "holes"),
                        counted(repairs.triangles_added, "triangle", "triangles"));
  }
  if (text.empty())
    text = fmt::format("  {:<12}nothing: no flaw that a repair knows\n", "repaired");
  what = "left";
  tell(repairs.slivers_left, "triangle without area", "triangles without area");
  tell(repairs.unorientable_components, "component that cannot be oriented, like a Moebius strip",
       "components that cannot be oriented, like a Moebius strip");
  tell(repairs.holes_left,
       "small hole, whose filling would fold, or touch or pass through the surface",
       "small holes, whose filling would fold, or touch or pass through the surface");
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

std::string describe(const PositionFit& fit, const MeshFacts& facts) {
  std::string text =
      fmt::format("  {:<12}by position: up to {:.3g} from their nodes", "", fit.farthest);
  if (facts.bounding_diagonal > 0) {
    text += fmt::format(", {:.3g}% of the mesh's diagonal",
                        100 * fit.farthest / facts.bounding_diagonal);
  }
  if (fit.left_out > 0) {
    text += fmt::format("; {} left out, nearest to the node of another", grouped(fit.left_out));
  }
  return text + "\n";
}

std::string describe_self_intersections(std::size_t pairs) {
  if (pairs == 0) return "";
  return counted(pairs, "pair of triangles crosses", "pairs of triangles cross");
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

std::string name_of_hole_size(const RepairOptions& options) {
  if (options.hole_edges > 0) return fmt::format("{}", options.hole_edges);
  return options.hole_share > 0 ? fmt::format("{:.6g}%", 100 * options.hole_share) : "off";
}

}  // namespace geolloyd
