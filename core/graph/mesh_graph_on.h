#pragma once

#include <utility>
#include <vector>

#include "core/graph/graph_on.h"
#include "core/graph/mesh_links_on.h"
#include "core/graph/spatial_order_on.h"
#include "core/mesh/mesh_edges_on.h"

namespace geolloyd {

/// Input ids that have nodes, ascending.
template <class Executor>
std::vector<std::uint32_t> used_input_ids(Executor& executor, const Mesh& mesh,
                                          const MeshGraph& target) {
  std::vector<std::uint8_t> referenced;
  if (has_vertices(target.kind)) referenced = referenced_vertices(executor, mesh);
  return items_where(executor, target.node_of.size(), [&](std::size_t id) {
    return target.is_triangle(static_cast<std::uint32_t>(id))
               ? has_three_vertices(mesh.triangles[id - target.first_triangle_id])
               : referenced[id] != 0;
  });
}

/// Vertex, or barycentre of the triangle.
Vec3 position_of(const Mesh& mesh, const MeshGraph& target, std::uint32_t id);

template <class Executor>
void number_nodes(Executor& executor, const Mesh& mesh, MeshGraph& target) {
  const std::vector<std::uint32_t> used = used_input_ids(executor, mesh, target);
  check_node_count(used.size());
  const std::vector<std::uint32_t> order = spatial_order_on(
      executor, used.size(), [&](std::size_t i) { return position_of(mesh, target, used[i]); });
  run_each(
      executor, [&] { target.input_id.resize(used.size()); },
      [&] { target.position.resize(used.size()); });
  for_items(executor, used.size(), small_items, [&](std::size_t node) {
    const std::uint32_t id = used[order[node]];
    target.node_of[id] = static_cast<NodeId>(node);
    target.input_id[node] = id;
    target.position[node] = position_of(mesh, target, id);
  });
}

/// Areas of triangles, and thirds of them for vertices, by node.
std::vector<double> node_masses(const Mesh& mesh, const MeshEdges& edges, const MeshGraph& target);

/// What make_mesh_graph knows before it begins. Throws InvalidInput.
MeshGraph start_mesh_graph(const Mesh& mesh, GraphKind kind);
void check_some_nodes(const MeshGraph& target);

/// See mesh_graph.h.
template <class Executor>
MeshGraph make_mesh_graph_on(Executor& executor, const Mesh& mesh, const MeshEdges& edges,
                             const MeshGraphOptions& options) {
  MeshGraph result = start_mesh_graph(mesh, options.kind);
  number_nodes(executor, mesh, result);
  check_some_nodes(result);
  const Buffer<Link> links = LinkBuilder<Executor>(executor, mesh, edges, options, result).build();
  result.graph = make_graph_on(executor, links, result.input_id.size(),
                               [&] { return node_masses(mesh, edges, result); });
  return result;
}

}  // namespace geolloyd
