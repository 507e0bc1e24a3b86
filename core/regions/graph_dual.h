#pragma once

#include <functional>
#include <vector>

#include "core/base/executor.h"
#include "core/dual/dual_mesh.h"
#include "core/graph/mesh_graph.h"
#include "core/lloyd/engine.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_topology.h"
#include "core/voronoi/partition.h"

namespace geolloyd {

/// How round the regions of a tessellation are: 4 pi area / perimeter^2.
struct Roundness {
  double mean = 0;
  double min = 0;
};

/// Why there are closed-ball violations left that further seeds might remove.
enum class ViolationsLeft {
  none,       ///< there are none, or none but those of the input
  not_asked,  ///< GraphDualOptions::manifold was false
  stopped,    ///< keep_going said so
  bounded,    ///< as many seeds were added as an input that is no manifold gets (dual_repair.h)
  no_room     ///< no node is left where a seed would help
};

/// The dual of a tessellation as a mesh: vertex r stands for region r; added seeds come last.
struct GraphDual {
  Mesh mesh;
  std::vector<NodeId> seeds;  ///< per vertex
  std::size_t seeds_added = 0;
  std::size_t reassigned_points =
      0;  ///< whose region was cut up by others' arcs (regions_of_nodes.h)
  std::vector<ClosedBallViolation> violations_found;  ///< before seeds were added
  std::vector<ClosedBallViolation> violations_left;
  ViolationsLeft why_left = ViolationsLeft::none;
  bool interrupted = false;      ///< keep_going ended the adding of seeds, or their moving
  std::size_t repeated = 0;      ///< corners left out, their triangle being there already
  std::size_t back_to_back = 0;  ///< triangles on others of opposite orientation
  std::size_t flipped = 0;       ///< triangles that face away from the surface
  std::size_t flat = 0;          ///< triangles without area (mesh_quality.h)
  std::size_t folds = 0;         ///< edges at which it turns back on itself (mesh_quality.h)
  std::vector<TrianglePair> self_intersections;  ///< (repair/crossings.h)
  MeshTopology topology;
  MeshTopology input_topology;
  Roundness roundness;  ///< of the regions that there were

  /// False also without triangles.
  [[nodiscard]] bool is_manifold() const;
  /// Of a manifold: each part has the Euler characteristic and the boundary loops of one of the
  /// input's. Of another input: no violation is
  /// left, and all that MeshTopology counts is the same.
  [[nodiscard]] bool has_input_topology() const;
};

/// What a remesh has to know of the edges of its mesh.
struct InputSurface {
  MeshTopology topology;
  MeshEdges edges;  ///< as make_region_surface wants them
};

/// `partition` is that of `seeds`, regions free; `engine` works on mesh_graph's graph.
struct GraphDualInput {
  const Mesh& mesh;
  const MeshGraph& mesh_graph;
  const std::vector<NodeId>& seeds;
  const Partition& partition;
  Engine& engine;
  Executor& executor = sequential();
  const InputSurface* surface = nullptr;  ///< of the mesh; null: it is found, which takes memory
};

struct GraphDualOptions {
  bool manifold = true;  ///< add seeds until the dual is one
  /// Where the vertices are that are not on the boundary, given the final seeds and their
  /// partition. Without it: at the seeds.
  std::function<std::vector<Vec3>(const std::vector<NodeId>& seeds, const Partition& partition)>
      sites;
  /// Asked now and then; false ends the adding of seeds. Without it: true.
  std::function<bool()> keep_going;
};

GraphDual make_graph_dual(const GraphDualInput& input, const GraphDualOptions& options);

}  // namespace geolloyd
