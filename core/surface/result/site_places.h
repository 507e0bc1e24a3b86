#pragma once

#include <span>
#include <vector>

#include "core/surface/fit/curve_fit.h"
#include "core/surface/substrate/surface_input.h"
#include "geolloyd/remesh.h"

namespace geolloyd {

/// Per site: the point of the mesh that is closest to it on the triangles about the vertex of its
/// cell that is nearest to it. Of equals, that with the smaller ids. A site without a cell has none
/// (no_id).
std::vector<SurfacePoint> place_sites(const Mesh& mesh, const SurfaceInput& input,
                                      const std::vector<Vec3>& sites,
                                      const std::vector<RegionId>& labels,
                                      Executor& executor = sequential());

/// Finds new places for vertices that a fit has moved away from theirs: those from `first` on. The
/// search starts in the cell of the vertex and goes downhill from vertex to vertex of the surface.
/// It crosses no curve: `on_curves` are the vertices of the curves.
void place_fitted(const Mesh& mesh, const SurfaceInput& input, const std::vector<Vec3>& fitted,
                  const std::vector<RegionId>& labels, std::span<const VertexId> on_curves,
                  std::size_t first, std::vector<SurfacePoint>& places,
                  Executor& executor = sequential());

/// Finds new places for vertices on curves that a fit has moved: on their curves.
void place_on_curves(const Mesh& mesh, const SurfaceInput& input,
                     std::span<const MovedCurveVertex> moved, const std::vector<RegionId>& labels,
                     std::vector<SurfacePoint>& places, Executor& executor = sequential());

/// The first places are those of corners (vertices of `input.fine`). Snaps those that coincide with
/// a vertex of the mesh to it, exactly.
void place_corners(const Mesh& mesh, const SurfaceInput& input, std::span<const VertexId> corners,
                   std::vector<SurfacePoint>& places);

/// The position of a point, mesh units.
Vec3 position_of(const Mesh& mesh, const SurfacePoint& point);

}  // namespace geolloyd
