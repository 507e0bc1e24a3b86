#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/graph.h"
#include "core/partition.h"
#include "parallel/scheduler.h"

namespace geolloyd {

/// Width of a bucket that suits most graphs, ticks: about one mean arc.
std::uint32_t suitable_delta(Scheduler& scheduler, const Graph& graph);

/// Multi-source search, regions free, by delta-stepping (Meyer, Sanders 2003): nodes within
/// `delta` ticks of each other are relaxed together, each thread collecting what it lowers in
/// buckets of its own, and going on by itself while a bucket it refills is small (bucket fusion:
/// Zhang et al., CGO 2020; GAP benchmark suite). Overwrites `keys`, one per node, with what
/// search_free (dijkstra.h) gives.
void search_free(Scheduler& scheduler, const Graph& graph, std::span<const NodeId> seeds,
                 std::uint32_t delta, std::vector<Key>& keys);

}  // namespace geolloyd
