#include "core/mesh/mesh_edges.h"

#include <algorithm>
#include <utility>

#include "core/mesh/mesh_edges_on.h"

namespace geolloyd {

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

MeshEdges find_edges(const Mesh& mesh) {
  Sequential one;
  return find_edges_on(one, mesh);
}

}  // namespace geolloyd
