#include "core/graph/geodesic_shortcuts.h"

#include <algorithm>

#include "core/base/loops.h"
#include "core/base/vec3.h"

namespace geolloyd {
namespace {

// Where the apex of a corner is if the edge opposite goes from 0, 0 to 1, 0; at the edge's start if
// the edge has no length.
UnfoldedPlace apex_by_edge(const Mesh& mesh, CornerId corner) {
  const Vec3& start = mesh.positions[edge_start(mesh, corner)];
  const Vec3 side = mesh.positions[edge_end(mesh, corner)] - start;
  const Vec3 offset = mesh.positions[apex(mesh, corner)] - start;
  const double square = dot(side, side);
  if (!(square > 0)) return {0, 0};
  return {dot(offset, side) / square, norm(cross(side, offset)) / square};
}

}  // namespace

GeodesicShortcuts::GeodesicShortcuts(const Mesh& mesh, const MeshEdges& edges, Executor& executor)
    : mesh_(mesh), apex_(3 * mesh.triangle_count()), opposite_(3 * mesh.triangle_count(), no_id) {
  parallel_for(executor, 3 * mesh.triangle_count(), small_items, [&](std::size_t corner) {
    apex_[corner] = apex_by_edge(mesh, static_cast<CornerId>(corner));
  });
  parallel_for(executor, edges.size(), small_items, [&](std::size_t e) {
    const auto corners = edges.corners(e);
    if (corners.size() != 2) return;
    opposite_[corners[0]] = corners[1];
    opposite_[corners[1]] = corners[0];
  });
  fans_ = corners_at_vertices(mesh, executor);
}

// The first direction is that of the edge's start.
CrossedEdge GeodesicShortcuts::first_edge(CornerId corner) const {
  const Vec3& origin = mesh_.positions[apex(mesh_, corner)];
  const Vec3 to_start = mesh_.positions[edge_start(mesh_, corner)] - origin;
  const Vec3 to_end = mesh_.positions[edge_end(mesh_, corner)] - origin;
  const Vec3 axis = normalized(to_start);
  const UnfoldedPlace right{norm(to_start), 0};
  const UnfoldedPlace left{dot(to_end, axis), norm(cross(axis, to_end))};
  return {nullptr, corner, edge_start(mesh_, corner), edge_end(mesh_, corner), right, left, right,
          left,    1};
}

// In lengths of the edge, which here has another length only by rounding.
UnfoldedPlace GeodesicShortcuts::unfolded(const CrossedEdge& edge, CornerId corner,
                                          bool is_forward) const {
  const double along = is_forward ? apex_[corner].x : 1 - apex_[corner].x;
  const double away = apex_[corner].y;
  const double x = edge.left_place.x - edge.right_place.x;
  const double y = edge.left_place.y - edge.right_place.y;
  return {edge.right_place.x + along * x + away * y, edge.right_place.y + along * y - away * x};
}

// Where the straight way to `end` crosses the edge.
Vec3 GeodesicShortcuts::crossing(const CrossedEdge& edge, const UnfoldedPlace& end) const {
  const double right = turn(edge.right_place, end);
  const double left = turn(end, edge.left_place);
  const double share = right + left > 0 ? std::clamp(right / (right + left), 0.0, 1.0) : 0.0;
  const Vec3& from = mesh_.positions[edge.right];
  return from + share * (mesh_.positions[edge.left] - from);
}

bool GeodesicShortcuts::has_short_detour(const CrossedEdge* last, const UnfoldedPlace& end) {
  const double longest = (1 + least_detour) * length(end);
  for (const CrossedEdge* edge = last; edge != nullptr; edge = edge->before) {
    for (const UnfoldedPlace& by : {edge->right_place, edge->left_place}) {
      if (length(by) + length({end.x - by.x, end.y - by.y}) < longest) return true;
    }
  }
  return false;
}

}  // namespace geolloyd
