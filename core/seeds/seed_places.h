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

/// A point of the surface, mesh units, and the triangle of the mesh that it is on, which has an
/// area.
struct SeedPlace {
  TriangleId triangle;
  Vec3 position;
};

/// Different nodes near `places`, in their order: of the nodes of the place's triangle (its
/// corners, the triangle, or both), the one nearest to the place that is not taken yet. If all are,
/// the first free node that a breadth-first search from there finds soon. A place about which all
/// is taken gets no seed.
std::vector<NodeId> seeds_near(const Mesh& mesh, const MeshGraph& mesh_graph,
                               std::span<const SeedPlace> places);

}  // namespace geolloyd
