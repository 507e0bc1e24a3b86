#include "core/mesh/mesh_edges.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/base/bucketing.h"
#include "core/base/loops.h"
#include "core/base/packing.h"

namespace geolloyd {
namespace {

// One entry per edge of each triangle, in the group of the edge's smaller vertex. The larger
// vertex in the high half, so that sorting a group brings equal edges together, corners ascending.
Bucketed<std::uint64_t> group_corners(Executor& executor, const Mesh& mesh) {
  return bucket_sort<std::uint64_t>(
      executor, mesh.vertex_count(), mesh.triangle_count(), [&](std::size_t t, auto&& put) {
        for_each_corner(mesh, t, [&](CornerId corner) {
          const auto [low, high] = ascending(edge_start(mesh, corner), edge_end(mesh, corner));
          put(low, (std::uint64_t{high} << 32) | corner);
        });
      });
}

VertexId high_end(std::uint64_t entry) {
  return static_cast<VertexId>(entry >> 32);
}

std::uint32_t count_edges(std::span<const std::uint64_t> sorted) {
  std::uint32_t count = sorted.empty() ? 0 : 1;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    count += high_end(sorted[i]) != high_end(sorted[i - 1]) ? 1 : 0;
  }
  return count;
}

// Whether there may be triangles with the same three vertices at an edge.
bool may_show_duplicates(const Mesh& mesh, const MeshEdges& edges, std::size_t edge) {
  const auto corners = edges.corners(edge);
  return corners.size() > 2 ||
         (corners.size() == 2 && apex(mesh, corners[0]) == apex(mesh, corners[1]));
}
// Duplicates share all three edges. They are looked for at one of them only: the one whose
// opposite corner is the largest vertex.
void append_duplicates(const Mesh& mesh, const MeshEdges& edges, std::size_t edge,
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

std::vector<TriangleId> find_duplicates(Executor& executor, const Mesh& mesh,
                                        const MeshEdges& edges) {
  std::vector<TriangleId> found;
  for (const std::uint32_t edge : pack_indices(executor, edges.size(), [&](std::size_t e) {
         return may_show_duplicates(mesh, edges, e);
       })) {
    append_duplicates(mesh, edges, edge, found);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

MeshEdges find_edges(const Mesh& mesh, Executor& executor) {
  Bucketed<std::uint64_t> groups = group_corners(executor, mesh);
  auto first_edge = huge_vector<std::uint32_t>(groups.size());
  parallel_for(executor, groups.size(), small_items, [&](std::size_t v) {
    sort_entries(groups[v]);
    first_edge[v] = count_edges(groups[v]);
  });
  const std::size_t count = exclusive_scan<std::uint32_t>(executor, first_edge);

  MeshEdges edges;
  parallel_invoke(
      executor, [&] { edges.ends = huge_vector<std::array<VertexId, 2>>(count); },
      [&] { edges.first_corner = huge_vector<std::uint32_t>(count + 1); },
      [&] { edges.corner = huge_vector<CornerId>(groups.entry.size()); });
  parallel_for(executor, groups.size(), small_items, [&](std::size_t low) {
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

std::vector<std::uint8_t> referenced_vertices(const Mesh& mesh, Executor& executor) {
  std::vector<std::uint8_t> referenced(mesh.vertex_count(), 0);
  parallel_for(executor, mesh.triangle_count(), small_items, [&](std::size_t t) {
    for_each_corner(mesh, t, [&](CornerId corner) {
      std::uint8_t& flag = referenced[apex(mesh, corner)];
      if (relaxed_load(flag) == 0) relaxed_store(flag, std::uint8_t{1});
    });
  });
  return referenced;
}

std::vector<Vec3> referenced_positions(const Mesh& mesh, Executor& executor) {
  const std::vector<std::uint8_t> referenced = referenced_vertices(mesh, executor);
  std::vector<Vec3> positions;
  positions.reserve(mesh.vertex_count());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    if (referenced[v] != 0) positions.push_back(mesh.positions[v]);
  }
  return positions;
}

}  // namespace geolloyd
