#include "core/graph/mesh_graph.h"

#include <string>
#include <utility>

#include "core/base/loops.h"
#include "core/base/packing.h"
#include "core/graph/mesh_arcs.h"
#include "core/mesh/mesh_measure.h"
#include "core/mesh/spatial_order.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

MeshGraph start_mesh_graph(const Mesh& mesh, GraphKind kind) {
  MeshGraph result;
  result.kind = kind;
  result.first_triangle_id = has_vertices(kind) ? mesh.vertex_count() : 0;
  const std::size_t ids =
      result.first_triangle_id + (has_triangles(kind) ? mesh.triangle_count() : 0);
  if (ids >= no_id) {
    throw InvalidInput("the mesh has more vertices and triangles than 32-bit ids can count");
  }
  result.node_of = huge_vector<NodeId>(ids, no_id);
  return result;
}

void check_some_nodes(const MeshGraph& target) {
  if (!target.input_id.empty()) return;
  throw InvalidInput("no triangle of the mesh has three different vertices: nothing to relax");
}

Vec3 position_of(const Mesh& mesh, const MeshGraph& target, std::uint32_t id) {
  return target.is_triangle(id)
             ? barycentre(mesh, static_cast<TriangleId>(id - target.first_triangle_id))
             : mesh.positions[id];
}

// Input ids that have nodes, ascending.
std::vector<std::uint32_t> used_input_ids(const Mesh& mesh, const MeshGraph& target,
                                          Executor& executor) {
  std::vector<std::uint8_t> referenced;
  if (has_vertices(target.kind)) referenced = referenced_vertices(mesh, executor);
  return pack_indices(executor, target.node_of.size(), [&](std::size_t id) {
    return target.is_triangle(static_cast<std::uint32_t>(id))
               ? has_three_vertices(mesh.triangles[id - target.first_triangle_id])
               : referenced[id] != 0;
  });
}

void number_nodes(const Mesh& mesh, MeshGraph& target, Executor& executor) {
  const std::vector<std::uint32_t> used = used_input_ids(mesh, target, executor);
  check_node_count(used.size());
  const std::vector<std::uint32_t> order = spatial_order(
      used.size(), [&](std::size_t i) { return position_of(mesh, target, used[i]); }, executor);
  parallel_invoke(
      executor, [&] { target.input_id = huge_vector<InputId>(used.size()); },
      [&] {
        reserve_huge(target.position, used.size());
        target.position.resize(used.size());
      });
  parallel_for(executor, used.size(), small_items, [&](std::size_t node) {
    const std::uint32_t id = used[order[node]];
    target.node_of[id] = static_cast<NodeId>(node);
    target.input_id[node] = id;
    target.position[node] = position_of(mesh, target, id);
  });
}

// Areas of triangles, and thirds of them for vertices, by node.
std::vector<double> node_masses(const Mesh& mesh, std::span<const TriangleId> duplicates,
                                const MeshGraph& target) {
  Buffer<double> of_triangle;
  if (has_triangles(target.kind)) of_triangle = triangle_areas(mesh, duplicates);
  std::vector<double> of_vertex;
  if (has_vertices(target.kind)) of_vertex = vertex_areas(mesh, duplicates);
  std::vector<double> masses;
  masses.reserve(target.input_id.size());
  for (const std::uint32_t id : target.input_id) {
    masses.push_back(target.is_triangle(id) ? of_triangle[id - target.first_triangle_id]
                                            : of_vertex[id]);
  }
  return masses;
}

MeshGraph numbered_nodes(const Mesh& mesh, const MeshGraphOptions& options, Executor& executor) {
  MeshGraph result = start_mesh_graph(mesh, options.kind);
  number_nodes(mesh, result, executor);
  check_some_nodes(result);
  for (std::size_t v = 0; v < options.welded_to.size() && has_vertices(options.kind); ++v) {
    result.node_of[v] = result.node_of[options.welded_to[v]];
  }
  return result;
}

void add_graph(const Mesh& mesh, std::span<const TriangleId> duplicates, Buffer<UndirectedArc> arcs,
               MeshGraph& result, Executor& executor) {
  result.graph = make_graph(
      std::move(arcs), result.input_id.size(),
      [&] { return node_masses(mesh, duplicates, result); }, executor);
}

}  // namespace

std::size_t count_nodes(const Mesh& mesh, GraphKind kind, Executor& executor) {
  const auto sum_of = [&](std::size_t items, auto&& is_node) {
    return parallel_reduce<std::size_t>(executor, items, small_items,
                                        [&](std::size_t begin, std::size_t end) {
                                          std::size_t count = 0;
                                          for (std::size_t i = begin; i < end; ++i) {
                                            count += is_node(i) ? 1 : 0;
                                          }
                                          return count;
                                        });
  };
  std::size_t nodes = 0;
  if (has_vertices(kind)) {
    const std::vector<std::uint8_t> referenced = referenced_vertices(mesh, executor);
    nodes += sum_of(referenced.size(), [&](std::size_t v) { return referenced[v] != 0; });
  }
  if (has_triangles(kind)) {
    nodes += sum_of(mesh.triangle_count(),
                    [&](std::size_t t) { return has_three_vertices(mesh.triangles[t]); });
  }
  return nodes;
}

void keep_for_arcs(MeshEdges& edges, GraphKind kind) {
  if (kind != GraphKind::vertex) return;
  edges = {std::move(edges.ends), {}, {}, std::move(edges.duplicates)};
}

MeshGraph make_mesh_graph(const Mesh& mesh, const MeshEdges& edges, const MeshGraphOptions& options,
                          Executor& executor) {
  MeshGraph result = numbered_nodes(mesh, options, executor);
  add_graph(mesh, edges.duplicates, find_arcs(mesh, edges, options, result, executor), result,
            executor);
  return result;
}

MeshGraph make_mesh_graph(const Mesh& mesh, MeshEdges&& edges, const MeshGraphOptions& options,
                          Executor& executor) {
  MeshGraph result = numbered_nodes(mesh, options, executor);
  Buffer<UndirectedArc> arcs = find_arcs(mesh, edges, options, result, executor);
  release_all_but_duplicates(edges);
  add_graph(mesh, edges.duplicates, std::move(arcs), result, executor);
  return result;
}

std::vector<Vec3> positions_of(const MeshGraph& mesh_graph, std::span<const NodeId> nodes) {
  std::vector<Vec3> positions;
  positions.reserve(nodes.size());
  for (const NodeId v : nodes) positions.push_back(mesh_graph.position[v]);
  return positions;
}

}  // namespace geolloyd
