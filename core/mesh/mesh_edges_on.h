#pragma once

#include <span>
#include <utility>

#include "core/base/grouping.h"
#include "core/mesh/mesh_edges.h"

namespace geolloyd {

/// The ends of the edge opposite to a corner, the smaller first.
inline std::pair<VertexId, VertexId> sorted_ends(const Mesh& mesh, CornerId corner) {
  return std::minmax({edge_start(mesh, corner), edge_end(mesh, corner)});
}

/// One entry per edge of each triangle, in the group of the edge's smaller vertex. The larger
/// vertex in the high half, so that sorting a group brings equal edges together, corners ascending.
template <class Executor>
Groups<std::uint64_t> group_corners(Executor& executor, const Mesh& mesh) {
  return group_items<std::uint64_t>(executor, mesh.vertex_count(), mesh.triangle_count(),
                                    [&](std::size_t t, auto&& put) {
                                      for_each_corner(mesh, t, [&](CornerId corner) {
                                        const auto [low, high] = sorted_ends(mesh, corner);
                                        put(low, (std::uint64_t{high} << 32) | corner);
                                      });
                                    });
}

inline VertexId high_end(std::uint64_t entry) {
  return static_cast<VertexId>(entry >> 32);
}

inline std::uint32_t count_edges(std::span<const std::uint64_t> sorted) {
  std::uint32_t count = sorted.empty() ? 0 : 1;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    count += high_end(sorted[i]) != high_end(sorted[i - 1]) ? 1 : 0;
  }
  return count;
}

/// Whether there may be triangles with the same three vertices at an edge.
inline bool may_show_duplicates(const Mesh& mesh, const MeshEdges& edges, std::size_t edge) {
  const auto corners = edges.corners(edge);
  return corners.size() > 2 ||
         (corners.size() == 2 && apex(mesh, corners[0]) == apex(mesh, corners[1]));
}
/// Duplicates share all three edges. They are looked for at one of them only: the one whose
/// opposite corner is the largest vertex.
void append_duplicates(const Mesh& mesh, const MeshEdges& edges, std::size_t edge,
                       std::vector<TriangleId>& found);

template <class Executor>
std::vector<TriangleId> find_duplicates(Executor& executor, const Mesh& mesh,
                                        const MeshEdges& edges) {
  std::vector<TriangleId> found;
  for (const std::uint32_t edge : items_where(executor, edges.size(), [&](std::size_t e) {
         return may_show_duplicates(mesh, edges, e);
       })) {
    append_duplicates(mesh, edges, edge, found);
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// See mesh_edges.h.
template <class Executor>
MeshEdges find_edges_on(Executor& executor, const Mesh& mesh) {
  Groups<std::uint64_t> groups = group_corners(executor, mesh);
  std::vector<std::uint32_t> first_edge(groups.size());
  for_items(executor, groups.size(), small_items, [&](std::size_t v) {
    sort_entries(groups[v]);
    first_edge[v] = count_edges(groups[v]);
  });
  const std::size_t count = exclusive_scan<std::uint32_t>(executor, first_edge);

  MeshEdges edges;
  run_each(
      executor, [&] { edges.ends.resize(count); }, [&] { edges.first_corner.resize(count + 1); },
      [&] { edges.corner.resize(groups.entry.size()); });
  for_items(executor, groups.size(), small_items, [&](std::size_t low) {
    std::uint32_t edge = first_edge[low];
    VertexId previous = no_id;
    for (const std::uint64_t& entry : groups[low]) {
      const auto i = static_cast<std::uint32_t>(&entry - groups.entry.data());
      if (high_end(entry) != previous) {
        previous = high_end(entry);
        edges.ends[edge] = {static_cast<VertexId>(low), previous};
        edges.first_corner[edge++] = i;
      }
      edges.corner[i] = static_cast<CornerId>(entry);
    }
  });
  edges.first_corner[count] = static_cast<std::uint32_t>(edges.corner.size());
  edges.duplicates = find_duplicates(executor, mesh, edges);
  return edges;
}

/// Per vertex, 1 where it is a corner of a triangle with three vertices, else 0.
template <class Executor>
std::vector<std::uint8_t> referenced_vertices(Executor& executor, const Mesh& mesh) {
  std::vector<std::uint8_t> referenced(mesh.vertex_count(), 0);
  for_items(executor, mesh.triangle_count(), small_items, [&](std::size_t t) {
    for_each_corner(mesh, t, [&](CornerId corner) {
      std::uint8_t& flag = referenced[apex(mesh, corner)];
      if (load(executor, flag) == 0) store(executor, flag, std::uint8_t{1});
    });
  });
  return referenced;
}

/// Positions of the vertices of usable triangles, by id.
template <class Executor>
std::vector<Vec3> referenced_positions(Executor& executor, const Mesh& mesh) {
  const std::vector<std::uint8_t> referenced = referenced_vertices(executor, mesh);
  std::vector<Vec3> positions;
  positions.reserve(mesh.vertex_count());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    if (referenced[v] != 0) positions.push_back(mesh.positions[v]);
  }
  return positions;
}

}  // namespace geolloyd
