#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/graph/mesh_graph.h"
#include "core/mesh/mesh.h"

namespace geolloyd {

/// Different nodes at the places of `triangles`, which have nodes in graphs of triangles and are
/// different themselves: so runs on different kinds of graph can begin alike. In graphs that have
/// triangles these are the nodes; in the others the corner nearest to the barycentre that is not
/// taken yet or, if all three are, the first free vertex that a breadth-first search from there
/// finds. So each component that holds one of the triangles gets a seed. Throws InvalidInput where
/// a component has fewer vertices than seeds.
std::vector<NodeId> seeds_at_triangles(const Mesh& mesh, const MeshGraph& mesh_graph,
                                       std::span<const std::uint32_t> triangles);

}  // namespace geolloyd
