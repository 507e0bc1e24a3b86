#pragma once

#include <string>
#include <vector>

#include "core/graph/mesh_graph.h"
#include "core/lloyd/engine.h"
#include "core/mesh/mesh_topology.h"
#include "core/remesh/dual_mesh.h"
#include "parallel/threads/scheduler.h"
#include "tools/words/names.h"

namespace geolloyd {

/// How round the regions of a tessellation are: 4 pi area / perimeter^2.
struct Roundness {
  double mean = 0;
  double min = 0;
};

/// The dual of a tessellation as a mesh: vertex r stands for region r; added seeds come last.
struct Remesh {
  Mesh mesh;
  std::vector<NodeId> seeds;  ///< per vertex
  std::size_t seeds_added = 0;
  std::size_t reassigned_points =
      0;  ///< nodes whose region was cut up by others' arcs (region_surface.h)
  std::vector<ClosedBallViolation> violations_found;  ///< before seeds were added
  std::vector<ClosedBallViolation> violations_left;
  std::size_t repeated = 0;  ///< corners left out, their triangle being there already
  std::size_t folded = 0;    ///< triangles on others of opposite orientation
  std::size_t flipped = 0;   ///< triangles that face away from the surface
  MeshTopology topology;
  MeshTopology input_topology;
  std::string flaw;     ///< why it is no manifold of the input's topology; empty where it is one
  Roundness roundness;  ///< of the regions that there were
};

/// `engine` has just found the partition of `seeds`, and works on mesh_graph's graph.
struct RemeshInput {
  const Mesh& mesh;
  const MeshGraph& mesh_graph;
  const std::vector<NodeId>& seeds;
  Engine& engine;
};

struct RemeshOptions {
  bool manifold = true;  ///< add seeds until the dual is one
  RemeshVertices vertices = RemeshVertices::seeds;
};

/// An interrupt (interrupt.h) ends the adding of seeds.
Remesh make_remesh(const RemeshInput& input, const RemeshOptions& options, Scheduler& scheduler);

}  // namespace geolloyd
