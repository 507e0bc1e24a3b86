#include "core/mesh_check.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/bounding_box.h"
#include "core/mesh_measure.h"

namespace geolloyd {
namespace {

/// Union-find over vertices, halving paths.
class Sets {
 public:
  explicit Sets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }

  std::uint32_t find(std::uint32_t x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  /// True where the two were apart.
  bool unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    (a < b ? parent_[b] : parent_[a]) = a < b ? a : b;
    return true;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

// Returns whether there may be duplicate triangles: they meet at an edge of two triangles with the
// same third vertex, or at one of more.
bool count_edges(const Mesh& mesh, const MeshEdges& edges, MeshFacts& facts) {
  bool may_repeat = false;
  facts.edges = edges.size();
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto corners = edges.corners(e);
    if (corners.size() == 1) ++facts.boundary_edges;
    if (corners.size() > 2) ++facts.non_manifold_edges;
    if (corners.size() != 2) continue;
    if (edge_start(mesh, corners[0]) == edge_start(mesh, corners[1])) ++facts.inconsistent_edges;
    may_repeat |= apex(mesh, corners[0]) == apex(mesh, corners[1]);
  }
  return may_repeat || facts.non_manifold_edges > 0;
}

void count_triangles(const Mesh& mesh, const std::vector<TriangleId>& duplicates,
                     MeshFacts& facts) {
  facts.triangles = mesh.triangle_count();
  facts.duplicate_triangles = duplicates.size();
  const std::vector<double> areas = triangle_areas(mesh, duplicates);
  std::size_t without_area = 0;
  for (std::size_t t = 0; t < areas.size(); ++t) {
    if (!has_three_vertices(mesh.triangles[t])) {
      ++facts.repeated_vertex_triangles;
    } else if (areas[t] == 0) {
      ++without_area;
    }
    facts.area += areas[t];
  }
  facts.zero_area_triangles = without_area - facts.duplicate_triangles;
}

void count_zero_length_edges(const Mesh& mesh, const MeshEdges& edges, MeshFacts& facts) {
  for (const auto& [a, b] : edges.ends) {
    if (mesh.positions[a] == mesh.positions[b]) ++facts.zero_length_edges;
  }
}

void count_vertices(const Mesh& mesh, const MeshEdges& edges, MeshFacts& facts) {
  facts.vertices = mesh.vertex_count();
  Sets sets(mesh.vertex_count());
  std::size_t unions = 0;
  for (const auto& [a, b] : edges.ends) unions += sets.unite(a, b) ? 1 : 0;
  const std::vector<bool> referenced = referenced_vertices(mesh);
  const auto used =
      static_cast<std::size_t>(std::count(referenced.begin(), referenced.end(), true));
  facts.unreferenced_vertices = mesh.vertex_count() - used;
  facts.components = used - unions;
}

}  // namespace

MeshFacts check_mesh(const Mesh& mesh, const MeshEdges& edges) {
  MeshFacts facts;
  const bool may_repeat = count_edges(mesh, edges, facts);
  count_triangles(mesh, may_repeat ? duplicate_triangles(mesh, edges) : std::vector<TriangleId>(),
                  facts);
  // The triangles at an edge without length have no area either: mostly there are none to look for.
  if (facts.zero_area_triangles + facts.duplicate_triangles > 0) {
    count_zero_length_edges(mesh, edges, facts);
  }
  count_vertices(mesh, edges, facts);
  facts.euler_characteristic =
      static_cast<std::int64_t>(facts.vertices - facts.unreferenced_vertices) -
      static_cast<std::int64_t>(facts.edges) +
      static_cast<std::int64_t>(facts.triangles - facts.repeated_vertex_triangles);
  facts.bounding_diagonal = norm(bounding_box(mesh.positions).extent());
  return facts;
}

}  // namespace geolloyd
