#include "core/mesh_measure.h"

#include <algorithm>
#include <utility>

namespace geolloyd {
namespace {

// Duplicates share all three edges. They are looked for at one of them only: the one whose opposite
// corner is the largest vertex.
void duplicates_at_edge(const Mesh& mesh, const MeshEdges& edges, std::size_t edge,
                        std::vector<TriangleId>& found) {
  std::vector<std::pair<VertexId, TriangleId>> around;
  for (const CornerId corner : edges.corners(edge)) {
    if (apex(mesh, corner) > edges.ends[edge][1]) {
      around.emplace_back(apex(mesh, corner), triangle_of(corner));
    }
  }
  std::sort(around.begin(), around.end());
  for (std::size_t i = 1; i < around.size(); ++i) {
    if (around[i].first == around[i - 1].first) found.push_back(around[i].second);
  }
}

double area(const Mesh& mesh, const Triangle& t) {
  const Vec3& a = mesh.positions[t[0]];
  return 0.5 * norm(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
}

}  // namespace

std::vector<TriangleId> duplicate_triangles(const Mesh& mesh, const MeshEdges& edges) {
  std::vector<TriangleId> found;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto corners = edges.corners(e);
    if (corners.size() < 2) continue;
    // The common case, two different triangles, without taking memory.
    if (corners.size() == 2 && apex(mesh, corners[0]) != apex(mesh, corners[1])) continue;
    duplicates_at_edge(mesh, edges, e, found);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<double> triangle_areas(const Mesh& mesh, std::span<const TriangleId> duplicates) {
  std::vector<double> areas(mesh.triangle_count());
  for (std::size_t t = 0; t < areas.size(); ++t) {
    areas[t] = has_three_vertices(mesh.triangles[t]) ? area(mesh, mesh.triangles[t]) : 0;
  }
  for (const TriangleId t : duplicates) areas[t] = 0;
  return areas;
}

std::vector<double> vertex_areas(const Mesh& mesh, const std::vector<double>& triangle_area) {
  std::vector<double> areas(mesh.vertex_count(), 0.0);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (const VertexId v : mesh.triangles[t]) areas[v] += triangle_area[t] / 3;
  }
  return areas;
}

Vec3 barycentre(const Mesh& mesh, TriangleId triangle) {
  const Triangle& t = mesh.triangles[triangle];
  return (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3;
}

}  // namespace geolloyd
