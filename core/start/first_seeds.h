#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/graph/components.h"
#include "core/graph/mesh_graph.h"
#include "core/mesh/mesh.h"
#include "core/seeds/seed_places.h"
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
/// `surface` for many, where the graph has some nodes for each; else `farthest`
/// (bench/results/local-minima.md).
SeedInit suited_init(std::size_t nodes, std::size_t count);

/// Whether first seeds of a graph of so many nodes are chosen near sites of the surface.
bool has_first_places(std::size_t nodes, const FirstSeedOptions& options);

/// Where these sites came to rest, if there are any to be. Takes twice the memory of a graph, and
/// needs none: so it comes before one is made. `duplicates` are the mesh's (mesh_edges.h).
std::vector<SeedPlace> find_first_places(const Mesh& mesh, std::span<const TriangleId> duplicates,
                                         std::size_t nodes, const FirstSeedOptions& options,
                                         Runtime& runtime);

/// `count` different nodes of a mesh's graph, by any way to choose them: choose_seeds (seeds.h),
/// and the ways that need more than the graph. `places` are those found with the same options.
/// Where sites of the surface, or seeds of a coarser graph, are too few in a component, its further
/// seeds are farthest points. Throws InvalidInput as choose_seeds does.
std::vector<NodeId> choose_first_seeds(const Mesh& mesh, std::span<const SeedPlace> places,
                                       const MeshGraph& mesh_graph, const Components& components,
                                       const FirstSeedOptions& options, Runtime& runtime);

}  // namespace geolloyd
