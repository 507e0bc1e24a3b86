#pragma once

#include "core/graph/mesh_graph.h"
#include "core/mesh/mesh.h"
#include "core/voronoi/graph_error.h"

namespace geolloyd {

/// By how much a ball of graph distances differs from the exact one, in shares of the exact area.
struct BallError {
  double area = 0;  ///< of the ball, less the exact one: negative where it is too small
  double symmetric_difference = 0;  ///< in one of both, but not in the other
};

/// The ball is where the distance from the source, linear within triangles, is below `radius`. In
/// graphs without vertices, a vertex has the mean distance of its triangles. Both areas are sums
/// over samples, the same number in each triangle. All 0 where no sample is in the exact ball.
BallError measure_ball_error(const Mesh& mesh, const MeshGraph& mesh_graph, NodeId source,
                             double radius, const ExactDistance& exact);

}  // namespace geolloyd
