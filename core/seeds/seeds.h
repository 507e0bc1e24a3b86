#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/graph/components.h"
#include "core/graph/graph.h"
#include "core/graph/mesh_graph.h"
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

/// Throws InvalidInput where a component has none of these seeds, and so would have no region.
/// `name` opens the message.
void check_every_component_has_a_seed(std::string_view name, const MeshGraph& mesh_graph,
                                      const Components& components, std::span<const NodeId> seeds);

}  // namespace geolloyd
