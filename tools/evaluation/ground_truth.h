#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/executor.h"
#include "core/graph/mesh_graph.h"
#include "core/mesh/mesh.h"
#include "core/voronoi/partition.h"
#include "tools/evaluation/statistics.h"

namespace geolloyd {

/// What a tessellation is judged by (thesis, section 6.1): the partition of the nodes by Euclidean
/// distance to the seeds instead of distance in the graph, and where the centroids of its regions
/// are. Nodes that the graph connects to no seed are left out of everything.
struct GroundTruth {
  std::vector<RegionId>
      region;  ///< per node: the nearest seed's, the smaller of equals; no_id: none

  // Per region. One without mass, as where another seed is in the same place, has its seed as its
  // centroid.
  std::vector<double> area;            ///< square mesh units
  std::vector<Vec3> centroid;          ///< of its nodes, by mass
  std::vector<Vec3> surface_centroid;  ///< the point of the surface closest to that
  std::vector<double> seed_distance;   ///< from the seed to that point, mesh units

  std::size_t unreached_nodes = 0;  ///< left out
  double node_agreement = 1;        ///< share of nodes that the graph puts into the same region
  double area_agreement = 1;        ///< the same by mass
  Statistics distance_in_edges;     ///< seed_distance over the mean side of a triangle
  Statistics distance_in_radii;  ///< seed_distance over the radius of a disc of the region's area
  double energy = 0;             ///< sum of mass * |node - seed|^2, mesh units
  double graph_energy = 0;       ///< the same sum, with the graph's regions
  double hexagonal = 0;  ///< energy of a hexagonal tiling of as much (base/hexagonal_energy.h)
};

/// `partition`: of the graph by these seeds, regions free. The same for any number of threads.
GroundTruth make_ground_truth(Executor& executor, const Mesh& mesh, const MeshGraph& mesh_graph,
                              const Partition& partition, std::span<const NodeId> seeds);

}  // namespace geolloyd
