#pragma once

#include <span>
#include <vector>

#include "core/graph/graph.h"
#include "core/voronoi/partition.h"

namespace geolloyd {

/// A graph whose nodes are the regions of a partition of another one, which reach all its nodes.
/// Two regions are as far apart as their seeds by way of the arcs between them; a region has the
/// mass of its nodes.
Graph contract(const Graph& graph, const Partition& partition, std::size_t regions,
               Executor& executor = sequential());

}  // namespace geolloyd
