#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "geolloyd/mesh.h"
#include "geolloyd/relax.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

struct DualOptions {
  bool manifold = true;              ///< add seeds until the dual has the topology of the mesh
  std::function<bool()> keep_going;  ///< asked now and then; false ends the adding of seeds
};

/// The dual of a tessellation of `mesh`: a mesh with a vertex for each region. Where the mesh is a
/// manifold, the dual is one of the same topology, if there are nodes enough for the seeds to add.
/// Throws InvalidInput where mesh and tessellation do not belong together.
struct Dual dual(const Mesh& mesh, const Tessellation& tessellation,
                 const DualOptions& options = {}, Runtime& runtime = all_threads());

/// A dual and what became of it. Vertex r is the seed of region r, or at a boundary a point of the
/// boundary near it. Added seeds come last. A triangle stands for each corner where three regions
/// meet, oriented as the mesh is there.
struct Dual {
  Mesh mesh;                    ///< may have no triangles, as with one region
  std::vector<InputId> seeds;   ///< per vertex
  std::size_t seeds_added = 0;  ///< where regions did not meet as they should
  bool interrupted = false;     ///< keep_going ended the adding of seeds
  bool is_manifold = false;
  bool has_input_topology = false;  ///< components, Euler characteristics, boundary loops
  bool is_input_manifold = false;
  std::size_t violations_left = 0;  ///< of the closed ball property; 0: the topology is proven
  std::size_t flipped = 0;          ///< triangles that face away from the surface
  std::size_t flat = 0;             ///< triangles without area
  std::size_t folds = 0;            ///< edges at which the dual turns back on itself
  std::vector<std::array<TriangleId, 2>>
      self_intersections;  ///< pairs of triangles, as self_intersections() finds them
};

}  // namespace geolloyd
