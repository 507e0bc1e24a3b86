#include "core/surface/result/labelled_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace geolloyd {
namespace {

// Whether a triangle names `to` right after `from`.
bool has_directed_edge(const FineMesh& fine, VertexId from, VertexId to) {
  const auto at = fine.triangles_at(from);
  return std::any_of(at.begin(), at.end(), [&](TriangleId i) {
    const Triangle& t = fine.triangles[i];
    return (t[0] == from && t[1] == to) || (t[1] == from && t[2] == to) ||
           (t[2] == from && t[0] == to);
  });
}

SurfaceTriangles triangles_with_caps(const FineMesh& fine, const FeatureCurves& curves) {
  if (curves.subresolution_holes.empty()) return SurfaceTriangles::of(fine.triangles);
  std::vector<Triangle> triangles = fine.triangles;
  for (const std::vector<VertexId>& loop : curves.subresolution_holes) {
    const bool runs_along = has_directed_edge(fine, loop[0], loop[1]);
    for (std::size_t i = 2; i < loop.size(); ++i) {
      Triangle cap = {loop[0], loop[i - 1], loop[i]};
      if (runs_along) std::swap(cap[1], cap[2]);
      triangles.push_back(cap);
    }
  }
  return SurfaceTriangles(std::move(triangles));
}

}  // namespace

RegionSurface label_surface(const SurfaceInput& input, const FeatureCurves& curves,
                            const LabelledSites& state, Executor& executor) {
  RegionSurface surface;
  surface.vertex_count = input.fine.vertex_count();
  surface.region_count = state.sites.size();
  surface.region = state.labels;
  surface.distance.resize(surface.vertex_count);
  parallel_for(executor, surface.vertex_count, small_items, [&](std::size_t v) {
    const Vec3 away = input.fine.positions[v] - state.sites.positions[state.labels[v]];
    surface.distance[v] = std::sqrt(input.fine.square_at(static_cast<VertexId>(v), away));
  });
  surface.triangles = triangles_with_caps(input.fine, curves);
  std::vector<std::uint8_t> is_at_subresolution_hole(surface.vertex_count, 0);
  for (const std::vector<VertexId>& loop : curves.subresolution_holes) {
    for (const VertexId v : loop) is_at_subresolution_hole[v] = 1;
  }
  for (const auto& ends : input.boundary_edges) {
    if (is_at_subresolution_hole[ends[0]] == 0) surface.irregular_edges.push_back({ends, 1});
  }
  return surface;
}

}  // namespace geolloyd
