#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/graph/components.h"
#include "core/graph/graph.h"
#include "core/graph/mesh_graph.h"
#include "geolloyd/choices.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

/// Throws InvalidInput where there are fewer seeds than components, or more than nodes.
void check_seed_count(const Graph& graph, const Components& components, std::size_t count);

/// `count` different nodes. Each component gets one, each further seed goes to the component with
/// the most mass per seed. The same for the same arguments everywhere; ties go to the smaller node.
/// The ways that need a mesh (start/first_seeds.h) choose farthest points here, without one. Throws
/// as check_seed_count.
std::vector<NodeId> choose_seeds(const Graph& graph, const Components& components, SeedInit init,
                                 std::size_t count, std::uint64_t random_seed,
                                 Runtime& runtime = reference_runtime());

/// `count` different nodes: as many of `given`, which are different, as each component's share has
/// room for, the first of them, and then those farthest from them.
std::vector<NodeId> complete_seeds(const Graph& graph, const Components& components,
                                   std::span<const NodeId> given, std::size_t count,
                                   std::uint64_t random_seed, Runtime& runtime);

/// `count` different nodes, ascending, with about equal masses between them in the order of nodes,
/// which is one of places; shared out among components as by choose_seeds.
std::vector<NodeId> spread_nodes(const Graph& graph, const Components& components,
                                 std::size_t count);

/// Throws InvalidInput where a component has none of these seeds, and so would have no region.
/// `name` opens the message.
void check_every_component_has_a_seed(std::string_view name, const MeshGraph& mesh_graph,
                                      const Components& components, std::span<const NodeId> seeds);

}  // namespace geolloyd
