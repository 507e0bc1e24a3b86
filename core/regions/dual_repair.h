#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/base/executor.h"
#include "core/dual/dual_mesh.h"
#include "core/graph/mesh_graph.h"
#include "core/lloyd/engine.h"
#include "core/mesh/mesh_edges.h"
#include "core/regions/regions_of_nodes.h"
#include "core/voronoi/partition.h"

namespace geolloyd {

/// Seeds, the surface of their regions, and the dual.
struct DualisedSeeds {
  std::vector<NodeId> seeds;  ///< different nodes
  RegionSurface surface;
  DualMesh dual;
};

/// What duals are made from.
struct DualInput {
  const Mesh& mesh;
  const MeshEdges& edges;
  const MeshGraph& mesh_graph;
  Executor& executor = sequential();
};

/// `partition` is that of `seeds`, regions free.
DualisedSeeds dualise(const DualInput& input, const Partition& partition,
                      std::vector<NodeId> seeds);

/// How many seeds repair_dual adds at most to so many regions of a mesh with edges of three and
/// more triangles: two for each region, so that loose triangles become triangles, and 64.
std::size_t most_seeds_added(std::size_t regions);

/// Adds seeds where the dual has violations (seed_insertion.h), until it has none but those of the
/// input (ClosedBallViolation) or nothing more can be added. On a mesh whose edges have two
/// triangles at most, the nodes are the only bound, and where there are enough of them no violation
/// is left. On others most_seeds_added() is the bound. Then the added seeds and those around them
/// move toward the centroids of their regions, as far as no violation comes back. The seeds that
/// were there stay the first ones, in their order. `engine` works on the input's graph;
/// `keep_going` is asked now and then, and ends it with what it has come to.
DualisedSeeds repair_dual(const DualInput& input, Engine& engine, DualisedSeeds flawed,
                          const std::function<bool()>& keep_going);

}  // namespace geolloyd
