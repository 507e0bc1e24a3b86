#pragma once

#include "core/base/executor.h"
#include "core/regions/graph_dual.h"
#include "tools/words/names.h"

namespace geolloyd {

/// What the command line asks for.
struct DualRequest {
  bool manifold = true;  ///< add seeds until the dual is one
  DualVertices vertices = DualVertices::seeds;
};

/// An interrupt (interrupt.h) ends the adding of seeds.
GraphDual make_graph_dual(const GraphDualInput& input, const DualRequest& request,
                          Executor& executor);

}  // namespace geolloyd
