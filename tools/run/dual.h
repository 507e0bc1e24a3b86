#pragma once

#include <optional>
#include <vector>

#include "core/mesh/quad_pairs.h"
#include "geolloyd/properties.h"
#include "tools/run/stages.h"

namespace geolloyd {

/// What is asked of a dual.
struct DualRequest {
  bool manifold = true;  ///< add seeds until the dual is one
  DualVertices vertices = DualVertices::seeds;
  bool quads = false;  ///< its triangles are joined to quadrilaterals
};

/// A dual and what goes with it.
struct MadeDual : GraphDual {
  std::optional<QuadPairs> quads;  ///< if they were wanted
  Properties properties;           ///< of the input; none until they are carried over
};

/// The dual of the regions of a run. `engine` works on its graph; `partition` is that of `seeds`.
/// An interrupt (interrupt.h) ends the adding of seeds.
MadeDual make_dual(const PreparedInput& run, const std::vector<NodeId>& seeds,
                   const Partition& partition, Engine& engine, const DualRequest& request,
                   Executor& executor);

/// The same with the properties of the input.
MadeDual make_whole_dual(const PreparedInput& run, const std::vector<NodeId>& seeds,
                         const Partition& partition, Engine& engine, const DualRequest& request,
                         Executor& executor);

}  // namespace geolloyd
