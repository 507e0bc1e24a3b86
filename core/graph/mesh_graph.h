#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/fields/tangent_field.h"
#include "core/graph/arc_length.h"
#include "core/graph/graph.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_edges.h"
#include "geolloyd/choices.h"

namespace geolloyd {

inline bool has_vertices(GraphKind kind) {
  return kind != GraphKind::triangle && kind != GraphKind::triangle_dense;
}
inline bool has_triangles(GraphKind kind) {
  return kind == GraphKind::triangle || kind == GraphKind::triangle_dense ||
         kind == GraphKind::mixed;
}

/// A graph and the mesh it came from. Nodes are in spatial order; everything people see speaks
/// input ids: vertex ids, or triangle ids, or in the mixed graph first the vertices, then triangle
/// t as vertex_count + t.
struct MeshGraph {
  GraphKind kind = GraphKind::vertex;
  Graph graph;
  std::vector<InputId> input_id;      ///< per node
  std::vector<NodeId> node_of;        ///< per input id; no_id where it has no node (mesh_check.h);
                                      ///< of a welded vertex, that of the one that stands for it
  std::vector<Vec3> position;         ///< per node: vertex, or barycentre of the triangle
  std::size_t first_triangle_id = 0;  ///< input ids from here on are triangles

  [[nodiscard]] bool is_triangle(InputId id) const { return id >= first_triangle_id; }
};

std::vector<Vec3> positions_of(const MeshGraph& mesh_graph, std::span<const NodeId> nodes);

struct MeshGraphOptions {
  GraphKind kind = GraphKind::vertex;
  Norm norm = Norm::geodesic;
  std::vector<TangentSpace> vertex_space;  ///< one per vertex, or none for the isotropic metric
  std::optional<Averaging> averaging =
      std::nullopt;                      ///< of spaces; none: suggested_averaging(norm)
  std::vector<VertexId> welded_to = {};  ///< of a mesh that was read (geolloyd/mesh.h), or none
};

/// Number of nodes that a graph will have.
std::size_t count_nodes(const Mesh& mesh, GraphKind kind, Executor& executor = sequential());

/// Number of arcs, in one direction, counted again for each vertex and edge by way of which two
/// nodes are joined. Many triangles at one edge or vertex make arcs by the square of their number.
/// Those of vertex_far are estimated.
std::uint64_t count_arcs(const Mesh& mesh, const MeshEdges& edges, GraphKind kind,
                         Executor& executor = sequential());

/// Gives back the memory of all that arcs are not made from: the corners in the vertex graph.
void keep_for_arcs(MeshEdges& edges, GraphKind kind);

/// Arc lengths: straight along edges and from barycentre to corner, unfolded across edges
/// (arc_length.h), measured by the norm in the averaged tangent spaces of the two ends, or along
/// the global axes without a field. Straight ways of vertex_far are measured triangle
/// by triangle, each in its own space, turned into its plane. Masses: triangle areas; a third of
/// the area around a vertex. A non-manifold edge joins all its triangles to each other. Throws
/// InvalidInput where nothing is left to make a graph of, 32-bit ids do not suffice, or a norm
/// other than geodesic is to average metrics.
MeshGraph make_mesh_graph(const Mesh& mesh, const MeshEdges& edges, const MeshGraphOptions& options,
                          Executor& executor = sequential());

/// The same. The edges give their memory back, all but that of the duplicates, as soon as the arcs
/// are made.
MeshGraph make_mesh_graph(const Mesh& mesh, MeshEdges&& edges, const MeshGraphOptions& options,
                          Executor& executor = sequential());

}  // namespace geolloyd
