#include "core/voronoi/ball_error.h"

#include <array>
#include <cstddef>
#include <vector>

#include "core/base/vec3.h"
#include "core/mesh/mesh_measure.h"

namespace geolloyd {
namespace {

constexpr int samples_per_side = 12;

std::vector<double> vertex_distances(const Mesh& mesh, const MeshGraph& made, NodeId source) {
  const std::vector<double> of_node = graph_distances(made.graph, source);
  std::vector<double> distances(mesh.vertex_count(), 0);
  if (has_vertices(made.kind)) {
    for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
      if (made.node_of[v] != no_id) distances[v] = of_node[made.node_of[v]];
    }
    return distances;
  }
  std::vector<double> count(mesh.vertex_count(), 0);
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    if (made.node_of[t] == no_id) continue;
    for (const VertexId v : mesh.triangles[t]) {
      distances[v] += of_node[made.node_of[t]];
      ++count[v];
    }
  }
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    if (count[v] > 0) distances[v] /= count[v];
  }
  return distances;
}

}  // namespace

BallError measure_ball_error(const Mesh& mesh, const MeshGraph& mesh_graph, NodeId source,
                             double radius, const ExactDistance& exact) {
  const std::vector<double> distances = vertex_distances(mesh, mesh_graph, source);
  const Vec3& centre = mesh_graph.position[source];
  const Buffer<double> areas = triangle_areas(mesh, {});
  double in_exact = 0;
  double in_found = 0;
  double in_one = 0;
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    for (int i = 0; i < samples_per_side; ++i) {
      for (int j = 0; j + i < samples_per_side; ++j) {
        const double u = (i + 1.0 / 3) / samples_per_side;
        const double v = (j + 1.0 / 3) / samples_per_side;
        const double w = 1 - u - v;
        const Vec3 place = u * mesh.positions[a] + v * mesh.positions[b] + w * mesh.positions[c];
        const bool is_exact = exact(centre, place) < radius;
        const bool is_found = u * distances[a] + v * distances[b] + w * distances[c] < radius;
        in_exact += is_exact ? areas[t] : 0;
        in_found += is_found ? areas[t] : 0;
        in_one += is_exact != is_found ? areas[t] : 0;
      }
    }
  }
  if (in_exact == 0) return {};
  return {(in_found - in_exact) / in_exact, in_one / in_exact};
}

}  // namespace geolloyd
