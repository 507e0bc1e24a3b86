#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/graph/components.h"
#include "core/graph/graph.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

/// Whether a graph of so many nodes is so fine that a coarser one is worth its while.
bool has_coarse_start(std::size_t nodes, std::size_t seeds);

/// `count` different nodes, where seeds rest that come from coarse graphs to fine ones. The
/// coarsest has some nodes for each seed; rounds of improvement cost little there. Each finer one
/// leaves few arcs to go. has_coarse_start(), and each component gets a seed (check_seed_count).
std::vector<NodeId> seeds_on_coarse_graphs(const Graph& graph, const Components& components,
                                           std::size_t count, std::uint64_t random_seed,
                                           Runtime& runtime);

}  // namespace geolloyd
