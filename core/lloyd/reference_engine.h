#pragma once

#include <memory>

#include "core/graph/graph.h"
#include "core/lloyd/engine.h"

namespace geolloyd {

/// The sequential engine, in the thesis's own terms: multi-source Dijkstra on a binary heap,
/// subtree sums pushed to parents through the nodes sorted by distance (the order in which they
/// settle), scores, moves. What every other engine must agree with. Keeps a reference to `graph`.
std::unique_ptr<Engine> make_reference_engine(const Graph& graph);

}  // namespace geolloyd
