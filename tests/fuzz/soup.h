#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/graph/mesh_graph.h"
#include "core/lloyd/relaxation.h"
#include "core/seeds/seeds.h"
#include "parallel/engine/parallel_engine.h"

namespace geolloyd::fuzz {

/// A small mesh of any kind, and all that is to be decided about what is done with it.
struct Soup {
  Mesh mesh;  ///< such as could come from a file (mesh_io.h); without triangles where none could
  MeshGraphOptions graph;
  std::size_t seeds = 0;  ///< beyond one per component; more than there are nodes: as many
  SeedInit init = SeedInit::random;
  std::uint64_t random_seed = 0;
  RelaxationOptions relaxation;
  std::size_t threads = 1;
  Backend backend = Backend::tbb;
  Frontier frontier = Frontier::automatic;
};

/// Bytes: fourteen decisions, then three per vertex, then three per triangle, to the end. Vertices
/// are on a coarse grid, where points coincide, lie in a line, and are equally far from each other;
/// a few values stand for tiny and huge coordinates.
Soup make_soup(std::span<const std::uint8_t> bytes);

}  // namespace geolloyd::fuzz
