#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/graph/components.h"
#include "core/graph/mesh_graph.h"
#include "core/mesh/mesh.h"
#include "geolloyd/choices.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

/// How many first seeds, and how they are chosen.
struct FirstSeedOptions {
  SeedInit init = SeedInit::automatic;
  std::size_t count = 0;
  std::uint64_t random_seed = 1;
  std::span<const TangentSpace> field = {};  ///< that the graph was made with: `surface` follows it
};

/// What `automatic` stands for: `coarse` for few seeds, where the graph is fine enough for it;
/// `surface` for many, where the graph has some nodes for each; else `farthest` (bench/README.md,
/// "Ways out of local minima").
SeedInit suited_init(std::size_t nodes, std::size_t count);

/// `count` different nodes of a mesh's graph, by any way to choose them: choose_seeds (seeds.h),
/// and the ways that need more than the graph. Where sites of the surface, or seeds of a coarser
/// graph, are too few in a component, its further seeds are farthest points. Throws InvalidInput as
/// choose_seeds does. `duplicates` are the mesh's (mesh_edges.h).
std::vector<NodeId> choose_first_seeds(const Mesh& mesh, std::span<const TriangleId> duplicates,
                                       const MeshGraph& mesh_graph, const Components& components,
                                       const FirstSeedOptions& options, Runtime& runtime);

}  // namespace geolloyd
