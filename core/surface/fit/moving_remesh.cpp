#include "core/surface/fit/moving_remesh.h"

namespace geolloyd {

std::vector<Vec3> normals_at_vertices(const Mesh& mesh) {
  std::vector<Vec3> normals(mesh.positions.size(), Vec3::Zero());
  for (const Triangle& t : mesh.triangles) {
    const std::vector<Vec3>& p = mesh.positions;
    const Vec3 doubled = cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
    for (const VertexId v : t) normals[v] += doubled;
  }
  for (Vec3& normal : normals) normal = normalized(normal);
  return normals;
}

MovingRemesh::MovingRemesh(const SurfaceFrame& frame, const Mesh& remesh, Executor& executor) {
  triangles = remesh.triangles;
  positions.reserve(remesh.vertex_count());
  for (const Vec3& p : remesh.positions) positions.push_back(frame.to_unit(p));
  start = positions;
  triangles_at = triangles_at_vertices(vertex_count(), triangles, executor);
}

}  // namespace geolloyd
