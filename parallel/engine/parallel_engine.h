#pragma once

#include <memory>

#include "core/graph/graph.h"
#include "core/lloyd/engine.h"
#include "geolloyd/threads.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {

/// The engine that works region by region on all threads of `scheduler`; it gives what the
/// reference engine gives, bit by bit. Keeps references to both arguments.
std::unique_ptr<Engine> make_parallel_engine(Scheduler& scheduler, const Graph& graph,
                                             Frontier frontier = Frontier::automatic);

}  // namespace geolloyd
