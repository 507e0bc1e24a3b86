#include "core/graph/mesh_graph.h"

#include <string>

#include "core/base/errors.h"
#include "core/graph/mesh_graph_on.h"

namespace geolloyd {

double length_in_metric(const Place& a, const Place& b, double isotropic, Norm norm_kind) {
  const bool in_field = a.space != nullptr && b.space != nullptr;
  if (!in_field && norm_kind == Norm::geodesic) return isotropic;
  const Vec3 chord = b.position - a.position;
  const double chord_length = norm(chord);
  if (chord_length == 0) return isotropic;
  const Vec3 displacement = chord * (isotropic / chord_length);
  return in_field ? measure(displacement, average(*a.space, *b.space), norm_kind)
                  : measure(displacement, norm_kind);
}

double straight_length(const Place& a, const Place& b, Norm norm_kind) {
  return length_in_metric(a, b, norm(b.position - a.position), norm_kind);
}

MeshGraph start_mesh_graph(const Mesh& mesh, GraphKind kind) {
  MeshGraph result;
  result.kind = kind;
  result.first_triangle_id = has_vertices(kind) ? mesh.vertex_count() : 0;
  const std::size_t ids =
      result.first_triangle_id + (has_triangles(kind) ? mesh.triangle_count() : 0);
  if (ids >= no_id) {
    throw InvalidInput("the mesh has more vertices and triangles than 32-bit ids can count");
  }
  result.node_of.assign(ids, no_id);
  return result;
}

void check_some_nodes(const MeshGraph& target) {
  if (!target.input_id.empty()) return;
  throw InvalidInput("no triangle of the mesh has three different vertices: nothing to tessellate");
}

Vec3 position_of(const Mesh& mesh, const MeshGraph& target, std::uint32_t id) {
  return target.is_triangle(id)
             ? barycentre(mesh, static_cast<TriangleId>(id - target.first_triangle_id))
             : mesh.positions[id];
}

std::vector<double> node_masses(const Mesh& mesh, const MeshEdges& edges, const MeshGraph& target) {
  const Buffer<double> of_triangle = triangle_areas(mesh, edges.duplicates);
  std::vector<double> of_vertex;
  if (has_vertices(target.kind)) of_vertex = vertex_areas(mesh, of_triangle);
  std::vector<double> masses;
  masses.reserve(target.input_id.size());
  for (const std::uint32_t id : target.input_id) {
    masses.push_back(target.is_triangle(id) ? of_triangle[id - target.first_triangle_id]
                                            : of_vertex[id]);
  }
  return masses;
}

std::uint64_t count_links(const Mesh& mesh, const MeshEdges& edges, GraphKind kind) {
  std::uint64_t links = has_vertices(kind) ? edges.size() : 0;
  for (std::size_t e = 0; kind != GraphKind::vertex && e < edges.size(); ++e) {
    links += pairs(edges.corners(e).size());
  }
  if (kind == GraphKind::mixed) links += edges.corner.size();
  if (kind == GraphKind::triangle_dense) {
    std::vector<std::uint32_t> fan(mesh.vertex_count(), 0);
    for (const CornerId corner : edges.corner) ++fan[apex(mesh, corner)];
    for (const std::uint32_t triangles : fan) links += pairs(triangles);
  }
  return links;
}

MeshGraph make_mesh_graph(const Mesh& mesh, const MeshEdges& edges,
                          const MeshGraphOptions& options) {
  Sequential one;
  return make_mesh_graph_on(one, mesh, edges, options);
}

std::vector<Vec3> positions_of(const MeshGraph& mesh_graph, std::span<const NodeId> nodes) {
  std::vector<Vec3> positions;
  positions.reserve(nodes.size());
  for (const NodeId v : nodes) positions.push_back(mesh_graph.position[v]);
  return positions;
}

}  // namespace geolloyd
