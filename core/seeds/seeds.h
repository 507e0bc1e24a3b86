#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/graph/components.h"
#include "core/graph/graph.h"
#include "core/voronoi/growing_search.h"

namespace geolloyd {

/// How the first seeds are chosen.
enum class SeedInit {
  random,            ///< uniformly over nodes (the thesis)
  random_area,       ///< with chances by mass
  farthest,          ///< each the node farthest from all before it (Gonzalez 1985)
  kmeans_plus_plus,  ///< with chances by mass * distance^2 to those before (Arthur, Vassilvitskii
                     ///< 2007)
};

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
