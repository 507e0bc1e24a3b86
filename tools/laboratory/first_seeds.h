#pragma once

#include <cstdint>
#include <vector>

#include "core/course/run_plan.h"
#include "core/mesh/mesh_edges.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

/// The first seeds of one batch, as triangles: all graphs of a mesh can begin with them.
struct FirstSeeds {
  std::size_t seeds;
  std::size_t batch;  ///< from 1
  std::vector<std::uint32_t> places;
};

/// For each number of seeds so many batches, each of them chosen on the triangle graph by a random
/// seed of its own. Throws InvalidInput where a batch cannot have so many seeds in each graph.
std::vector<FirstSeeds> choose_first_seeds(const SeedPlan& how,
                                           const std::vector<std::size_t>& counts,
                                           std::size_t batches, const Mesh& mesh,
                                           const MeshEdges& edges, Runtime& runtime);

}  // namespace geolloyd
