#pragma once

#include <memory>

#include "core/graph/graph.h"
#include "core/voronoi/growing_search.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {

/// The same keys, by delta-stepping: large searches by all threads, small ones by one. Keeps
/// references to both arguments.
std::unique_ptr<GrowingSearch> make_parallel_growing_search(Scheduler& scheduler,
                                                            const Graph& graph);

}  // namespace geolloyd
