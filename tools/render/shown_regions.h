#pragma once

#include <span>
#include <vector>

#include "core/graph/mesh_graph.h"
#include "core/voronoi/partition.h"
#include "tools/render/scene.h"

namespace geolloyd {

// The region that each sample of a scene shows, no_id where there is none. Where a node is its own
// region shows; between nodes borders do not follow the triangles' edges but run straight across
// the triangles.

/// Of a partition, regions free: between nodes distances change evenly.
std::vector<RegionId> show_partition(const Scene& scene, const MeshGraph& mesh_graph,
                                     const Partition& partition, Executor& executor);

/// Of the regions, one per node, whose points are nearest to their own seed through space.
std::vector<RegionId> show_nearest(const Scene& scene, const MeshGraph& mesh_graph,
                                   std::span<const RegionId> region_of_node,
                                   std::span<const Vec3> seed_position, Executor& executor);

}  // namespace geolloyd
