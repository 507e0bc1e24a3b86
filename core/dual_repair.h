#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/dual_mesh.h"
#include "core/engine.h"
#include "core/mesh_graph.h"

namespace geolloyd {

/// A tessellation's dual, and the seeds it took.
struct DualRepair {
  std::vector<NodeId> seeds;  ///< those that were given, some moved a little, then those added
  RegionSurface surface;      ///< of these seeds' regions
  DualMesh dual;              ///< its obstacles are those that remain
  std::size_t added = 0;
  std::size_t rounds = 0;  ///< of adding seeds
};

/// Makes the dual of the tessellation by `seeds` and, with `repair`, adds seeds where obstacles
/// are, lets them and the regions around them settle, and begins again, until no obstacle is left
/// or nothing more can be added. `seeds` are different nodes, and `engine` works on mesh_graph's
/// graph; it may have found their partition already, which then costs little. `keep_going` is asked
/// before each round.
DualRepair make_dual_of(const Mesh& mesh, const MeshEdges& edges, const MeshGraph& mesh_graph,
                        Engine& engine, std::span<const NodeId> seeds, bool repair,
                        const std::function<bool()>& keep_going);

}  // namespace geolloyd
