#pragma once

#include <vector>

#include "core/surface/flips/glide_trial.h"

namespace geolloyd {

struct VertexMoves {
  std::vector<VertexId> moved;    ///< ascending, each once
  std::vector<VertexId> changed;  ///< all about which something is different
  std::size_t count = 0;
};

/// Takes vertices away where that leaves fewer irregular ones (an edge collapses), and puts each
/// back where one more leaves fewer, too (a vertex splits), wherever both together pay. So the
/// number of vertices stays.
///
/// Both are tried near all irregular vertices at once. The best are paired, if they are far enough
/// apart. Then it is done again where something has changed.
VertexMoves move_vertices(GlidingRemesh& remesh, Executor& executor = sequential());

}  // namespace geolloyd
