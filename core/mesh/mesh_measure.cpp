#include "core/mesh/mesh_measure.h"

#include <algorithm>

#include "core/base/loops.h"

namespace geolloyd {

double triangle_area(const Mesh& mesh, const Triangle& triangle) {
  if (!has_three_vertices(triangle)) return 0;
  const Vec3& a = mesh.positions[triangle[0]];
  return 0.5 * norm(cross(mesh.positions[triangle[1]] - a, mesh.positions[triangle[2]] - a));
}

Buffer<double> triangle_areas(const Mesh& mesh, std::span<const TriangleId> duplicates,
                              Executor& executor) {
  Buffer<double> areas(mesh.triangle_count());
  parallel_for(executor, areas.size(), small_items,
               [&](std::size_t t) { areas[t] = triangle_area(mesh, mesh.triangles[t]); });
  for (const TriangleId t : duplicates) areas[t] = 0;
  return areas;
}

std::vector<double> vertex_areas(const Mesh& mesh, std::span<const TriangleId> duplicates) {
  std::vector<double> areas(mesh.vertex_count(), 0.0);
  auto duplicate = duplicates.begin();
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    if (duplicate != duplicates.end() && *duplicate == t) {
      ++duplicate;
      continue;
    }
    const double third = triangle_area(mesh, mesh.triangles[t]) / 3;
    for (const VertexId v : mesh.triangles[t]) areas[v] += third;
  }
  return areas;
}

// About a vertex, so that a mesh far from the origin loses no digits.
double enclosed_volume(const Mesh& mesh) {
  double six_fold = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3& o = mesh.positions.front();
    six_fold += dot(mesh.positions[a] - o, cross(mesh.positions[b] - o, mesh.positions[c] - o));
  }
  return six_fold / 6;
}

double flatness(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest = std::max({norm(b - a), norm(c - b), norm(a - c)});
  return longest > 0 ? norm(cross(b - a, c - a)) / (longest * longest) : 0;
}

Vec3 barycentre(const Mesh& mesh, TriangleId triangle) {
  const Triangle& t = mesh.triangles[triangle];
  return (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3;
}

}  // namespace geolloyd
