#include "core/mesh/connectivity.h"

namespace geolloyd {

Bucketed<TriangleId> triangles_at_vertices(std::size_t vertices,
                                           std::span<const Triangle> triangles,
                                           Executor& executor) {
  return bucket_sort<TriangleId>(executor, vertices, triangles.size(),
                                 [&](std::size_t t, auto&& put) {
                                   for (const VertexId v : triangles[t])
                                     put(v, static_cast<TriangleId>(t));
                                 });
}

Bucketed<CornerId> corners_at_vertices(const Mesh& mesh, Executor& executor) {
  return bucket_sort<CornerId>(
      executor, mesh.vertex_count(), mesh.triangle_count(), [&](std::size_t t, auto&& put) {
        for_each_corner(mesh, t, [&](CornerId corner) { put(apex(mesh, corner), corner); });
      });
}

Bucketed<std::uint32_t> edges_at_vertices(std::size_t vertices, const MeshEdges& edges,
                                          Executor& executor) {
  return bucket_sort<std::uint32_t>(executor, vertices, edges.size(),
                                    [&](std::size_t e, auto&& put) {
                                      for (const VertexId v : edges.ends[e])
                                        put(v, static_cast<std::uint32_t>(e));
                                    });
}

}  // namespace geolloyd
