#pragma once

#include <memory>

#include "core/graph/graph.h"
#include "core/lloyd/engine.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {

/// How regions are found when they are free. The result is the same.
enum class Frontier {
  heap,       ///< from scratch, by one thread (dijkstra.h)
  delta,      ///< from scratch, by all (delta_stepping.h)
  regions,    ///< from the last ones, only where they change; at first like delta
  automatic,  ///< the fastest: so far that is regions in all cases measured
};

/// The engine that works region by region on all threads of `scheduler`; it gives what the
/// reference engine gives, bit by bit. Keeps references to both arguments.
std::unique_ptr<Engine> make_parallel_engine(Scheduler& scheduler, const Graph& graph,
                                             Frontier frontier = Frontier::automatic);

}  // namespace geolloyd
