#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/graph/components.h"
#include "core/graph/graph.h"
#include "core/voronoi/growing_search.h"
#include "geolloyd/choices.h"

namespace geolloyd {

/// `count` different nodes. Each component gets one, each further seed goes to the component with
/// the most mass per seed. The same for the same arguments everywhere; ties go to the smaller node.
/// Throws InvalidInput where there are fewer seeds than components, or more than nodes.
std::vector<NodeId> choose_seeds(const Graph& graph, const Components& components, SeedInit init,
                                 std::size_t count, std::uint64_t random_seed);

/// The same, with another way of searching; `search` has no seeds yet.
std::vector<NodeId> choose_seeds(const Graph& graph, const Components& components, SeedInit init,
                                 std::size_t count, std::uint64_t random_seed,
                                 GrowingSearch& search);

}  // namespace geolloyd
