#pragma once

#include "core/remesh/remesh.h"
#include "parallel/threads/scheduler.h"
#include "tools/words/names.h"

namespace geolloyd {

/// What the command line asks for.
struct RemeshRequest {
  bool manifold = true;  ///< add seeds until the dual is one
  RemeshVertices vertices = RemeshVertices::seeds;
};

/// An interrupt (interrupt.h) ends the adding of seeds.
GraphRemesh make_remesh(const RemeshInput& input, const RemeshRequest& request,
                        Scheduler& scheduler);

}  // namespace geolloyd
