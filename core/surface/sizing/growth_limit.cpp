#include "core/surface/sizing/growth_limit.h"

#include <cmath>
#include <functional>
#include <queue>
#include <utility>

#include "core/base/vec3.h"
#include "core/mesh/connectivity.h"

namespace geolloyd {

void limit_growth(const Mesh& mesh, const MeshEdges& edges, double growth,
                  std::vector<double>& lengths, Executor& executor) {
  const double slope = growth - 1;
  if (!std::isfinite(slope)) return;
  const auto way = [&](VertexId a, VertexId b) {
    return norm(mesh.positions[a] - mesh.positions[b]);
  };
  // Only where a neighbour is too long does anything follow from a vertex.
  using Entry = std::pair<double, VertexId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const auto& [a, b] : edges.ends) {
    const auto [shorter, longer] = lengths[a] <= lengths[b] ? std::pair(a, b) : std::pair(b, a);
    if (lengths[shorter] + slope * way(a, b) < lengths[longer]) {
      queue.emplace(lengths[shorter], shorter);
    }
  }
  if (queue.empty()) return;
  const auto edges_at = edges_at_vertices(mesh.vertex_count(), edges, executor);
  while (!queue.empty()) {
    const auto [length, v] = queue.top();
    queue.pop();
    if (length > lengths[v]) continue;
    for (const std::uint32_t e : edges_at[v]) {
      const auto& [a, b] = edges.ends[e];
      const VertexId u = a == v ? b : a;
      const double limit = length + slope * way(v, u);
      if (!(limit < lengths[u])) continue;
      lengths[u] = limit;
      queue.emplace(limit, u);
    }
  }
}

}  // namespace geolloyd
