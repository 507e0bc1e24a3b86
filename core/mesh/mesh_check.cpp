#include "core/mesh/mesh_check.h"

#include <algorithm>
#include <vector>

#include "core/base/bounding_box.h"
#include "core/base/disjoint_sets.h"
#include "core/mesh/mesh_measure.h"

namespace geolloyd {
namespace {

struct EdgeCounts {
  std::size_t boundary = 0;
  std::size_t non_manifold = 0;
  std::size_t inconsistent = 0;
  std::size_t zero_length = 0;
  std::size_t joining = 0;  // components of what came before

  EdgeCounts& operator+=(const EdgeCounts& more) {
    boundary += more.boundary;
    non_manifold += more.non_manifold;
    inconsistent += more.inconsistent;
    zero_length += more.zero_length;
    joining += more.joining;
    return *this;
  }
};

EdgeCounts count_edges(const Mesh& mesh, const MeshEdges& edges, bool may_have_no_length,
                       Executor& executor) {
  DisjointSets sets(mesh.vertex_count(), executor);
  return parallel_reduce<EdgeCounts>(
      executor, edges.size(), small_items, [&](std::size_t begin, std::size_t end) {
        EdgeCounts counts;
        for (std::size_t e = begin; e < end; ++e) {
          const auto [a, b] = edges.ends[e];
          const auto corners = edges.corners(e);
          if (corners.size() == 1) ++counts.boundary;
          if (corners.size() > 2) ++counts.non_manifold;
          if (corners.size() == 2 && edge_start(mesh, corners[0]) == edge_start(mesh, corners[1])) {
            ++counts.inconsistent;
          }
          if (may_have_no_length && mesh.positions[a] == mesh.positions[b]) ++counts.zero_length;
          if (sets.unite(a, b)) ++counts.joining;
        }
        return counts;
      });
}

// Area is added up in the order of the triangles, whoever computed it.
void measure_triangles(const Mesh& mesh, const MeshEdges& edges, MeshFacts& facts,
                       Executor& executor) {
  facts.triangles = mesh.triangle_count();
  facts.duplicate_triangles = edges.duplicates.size();
  std::size_t without_area = 0;
  for (const double area : triangle_areas(mesh, edges.duplicates, executor)) {
    facts.area += area;
    if (area == 0) ++without_area;
  }
  facts.repeated_vertex_triangles = facts.triangles - edges.corner.size() / 3;
  facts.zero_area_triangles =
      without_area - facts.repeated_vertex_triangles - facts.duplicate_triangles;
}

}  // namespace

MeshFacts check_mesh(const Mesh& mesh, const MeshEdges& edges, Executor& executor) {
  MeshFacts facts;
  measure_triangles(mesh, edges, facts, executor);

  // The triangles at an edge without length have no area either: mostly there are none to look for.
  const EdgeCounts counts =
      count_edges(mesh, edges, facts.zero_area_triangles + facts.duplicate_triangles > 0, executor);
  facts.edges = edges.size();
  facts.boundary_edges = counts.boundary;
  facts.non_manifold_edges = counts.non_manifold;
  facts.inconsistent_edges = counts.inconsistent;
  facts.zero_length_edges = counts.zero_length;

  const std::vector<std::uint8_t> referenced = referenced_vertices(mesh, executor);
  const auto used = static_cast<std::size_t>(std::count(referenced.begin(), referenced.end(), 1));
  facts.vertices = mesh.vertex_count();
  facts.unreferenced_vertices = facts.vertices - used;
  facts.components = used - counts.joining;
  facts.euler_characteristic =
      static_cast<std::int64_t>(used) - static_cast<std::int64_t>(facts.edges) +
      static_cast<std::int64_t>(facts.triangles - facts.repeated_vertex_triangles);
  const auto first_used = static_cast<std::size_t>(
      std::find(referenced.begin(), referenced.end(), 1) - referenced.begin());
  facts.bounding_diagonal = norm(bounding_box(
                                     used > 0 ? mesh.vertex_count() : 0,
                                     [&](std::size_t v) -> const Vec3& {
                                       return mesh.positions[referenced[v] != 0 ? v : first_used];
                                     },
                                     executor)
                                     .extent());
  return facts;
}

}  // namespace geolloyd
