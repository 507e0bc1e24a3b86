#include "core/mesh/mesh_topology.h"

#include <algorithm>

#include "core/base/disjoint_sets.h"
#include "core/base/loops.h"

namespace geolloyd {
namespace {

// The corner of the triangle of `corner` at vertex `v`.
CornerId corner_at(const Mesh& mesh, CornerId corner, VertexId v) {
  const CornerId first = corner - corner % 3;
  for (CornerId c = first; c < first + 2; ++c) {
    if (apex(mesh, c) == v) return c;
  }
  return first + 2;
}

// Triangles around a vertex, joined across its edges, are one fan where it is manifold.
std::size_t count_broken_vertices(const Mesh& mesh, const MeshEdges& edges, Executor& executor) {
  DisjointSets fans(3 * mesh.triangle_count(), executor);
  parallel_for(executor, edges.size(), small_items, [&](std::size_t e) {
    const auto corners = edges.corners(e);
    for (const VertexId end : edges.ends[e]) {
      const CornerId first = corner_at(mesh, corners[0], end);
      for (const CornerId c : corners.subspan(1)) fans.unite(first, corner_at(mesh, c, end));
    }
  });
  std::vector<std::uint8_t> fan_count(mesh.vertex_count(), 0);  // 2: or more
  parallel_for(executor, mesh.triangle_count(), small_items, [&](std::size_t t) {
    for_each_corner(mesh, t, [&](CornerId c) {
      std::uint8_t& count = fan_count[apex(mesh, c)];
      if (fans.find(c) != c) return;
      if (!compare_exchange(count, std::uint8_t{0}, std::uint8_t{1})) {
        relaxed_store(count, std::uint8_t{2});
      }
    });
  });
  return static_cast<std::size_t>(std::count(fan_count.begin(), fan_count.end(), 2));
}

std::vector<PartTopology> find_parts(const Mesh& mesh, const MeshEdges& edges, Executor& executor) {
  DisjointSets connected(mesh.vertex_count(), executor);
  parallel_for(executor, edges.size(), small_items,
               [&](std::size_t e) { connected.unite(edges.ends[e][0], edges.ends[e][1]); });

  std::vector<PartTopology> of_root(mesh.vertex_count());
  std::vector<std::uint8_t> is_used(mesh.vertex_count(), 0);
  std::vector<std::uint8_t> is_outer(mesh.vertex_count(), 0);
  DisjointSets loops(mesh.vertex_count());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto [a, b] = edges.ends[e];
    PartTopology& part = of_root[connected.find(a)];
    --part.euler_characteristic;
    is_used[a] = is_used[b] = 1;
    if (edges.corners(e).size() != 1) continue;
    is_outer[a] = is_outer[b] = 1;
    if (!loops.unite(a, b)) ++part.boundary_loops;
  }
  for (const CornerId c : edges.corner) {
    if (c % 3 == 0) ++of_root[connected.find(apex(mesh, c))].euler_characteristic;
  }
  std::vector<PartTopology> parts;
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    if (is_used[v] != 0) ++of_root[connected.find(v)].euler_characteristic;
  }
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    if (is_used[v] != 0 && connected.find(v) == v) parts.push_back(of_root[v]);
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

}  // namespace

PartTopology MeshTopology::total() const {
  PartTopology sum;
  for (const PartTopology& part : parts) {
    sum.euler_characteristic += part.euler_characteristic;
    sum.boundary_loops += part.boundary_loops;
  }
  return sum;
}

MeshTopology find_topology(const Mesh& mesh, const MeshEdges& edges, Executor& executor) {
  MeshTopology topology;
  topology.parts = find_parts(mesh, edges, executor);
  topology.non_manifold_vertices = count_broken_vertices(mesh, edges, executor);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto corners = edges.corners(e);
    if (corners.size() > 2) ++topology.non_manifold_edges;
    if (corners.size() == 2 && edge_start(mesh, corners[0]) == edge_start(mesh, corners[1])) {
      ++topology.inconsistent_edges;
    }
  }
  return topology;
}

MeshTopology find_topology(const Mesh& mesh) {
  validate_contents(mesh);
  return find_topology(mesh, find_edges(mesh));
}

}  // namespace geolloyd
