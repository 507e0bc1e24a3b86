#pragma once

#include <vector>

#include "core/base/executor.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_edges.h"
#include "geolloyd/choices.h"

namespace geolloyd {

/// A cross per vertex: two directions at a right angle in its tangent plane, with magnitudes of 1,
/// as smooth as can be. It is what norms other than the geodesic one want as their axes. Crosses
/// follow the boundary, edges of more than two triangles and edges where the surface bends by over
/// 40 degrees. Elsewhere they follow the directions of curvature (curvature_field.h), the more so
/// the more those differ.
///
/// A cross is the fourth power of a direction, as a complex number. Neighbours are turned from
/// plane to plane. A cross becomes the mean of itself, its neighbours and what it is to follow, a
/// fixed number of times: first on pairs of pairs of vertices, some dozen in all, then from coarse
/// to fine (as Jakob et al. 2015). O(triangles).
std::vector<TangentSpace> cross_field(const Mesh& mesh, const MeshEdges& edges,
                                      Executor& executor = sequential());

}  // namespace geolloyd
