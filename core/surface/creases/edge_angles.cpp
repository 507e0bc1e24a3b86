#include "core/surface/creases/edge_angles.h"

#include "core/base/loops.h"

namespace geolloyd {

EdgeAngles::EdgeAngles(const Mesh& mesh, const MeshEdges& edges, Executor& executor)
    : mesh_(mesh), edges_(edges), normal_(mesh.triangle_count()) {
  parallel_for(executor, normal_.size(), small_items, [&](std::size_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const std::vector<Vec3>& p = mesh.positions;
    normal_[t] = normalized(cross(p[b] - p[a], p[c] - p[a]));
  });
}

std::optional<double> EdgeAngles::cosine(EdgeId e) const {
  const std::span<const CornerId> corners = edges_.corners(e);
  if (corners.size() != 2) return std::nullopt;
  const TriangleId a = triangle_of(corners[0]);
  const TriangleId b = triangle_of(corners[1]);
  if (!has_area(a) || !has_area(b)) return std::nullopt;
  const double between = dot(normal_[a], normal_[b]);
  return is_turned_round(e) ? -between : between;
}

bool EdgeAngles::is_as_sharp(EdgeId e, double cosine) const {
  constexpr double rounding = 1e-9;
  const std::optional<double> own = this->cosine(e);
  return own && *own <= cosine + rounding;
}

double EdgeAngles::length(EdgeId e) const {
  const auto& [a, b] = edges_.ends[e];
  return norm(mesh_.positions[a] - mesh_.positions[b]);
}

bool EdgeAngles::is_turned_round(EdgeId e) const {
  const std::span<const CornerId> corners = edges_.corners(e);
  return edge_start(mesh_, corners[0]) != edge_end(mesh_, corners[1]);
}

}  // namespace geolloyd
