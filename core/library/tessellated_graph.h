#pragma once

#include <span>
#include <vector>

#include "core/graph/mesh_graph.h"
#include "core/lloyd/relaxation.h"
#include "geolloyd/relax.h"

namespace geolloyd {

/// What a Tessellation keeps for those who go on from it: the graph, and the relaxation in its
/// terms (nodes, ticks).
struct TessellatedGraph {
  std::uint64_t mesh_digest = 0;  ///< of the mesh it is of
  MeshGraph mesh_graph;
  Relaxation relaxation;
};

/// First seeds of a user, by input id, as nodes in their order. Throws InvalidInput where one is
/// unknown, without a node or repeated.
std::vector<NodeId> nodes_of_seeds(const MeshGraph& mesh_graph, std::span<const InputId> seeds);

/// The same field with directions of length 1; those that are so long but for rounding stay. Throws
/// InvalidInput where it is neither empty nor one usable space per vertex.
std::vector<TangentSpace> checked_field(std::span<const TangentSpace> field,
                                        std::size_t vertex_count);

/// 64 bits for all positions and triangles.
std::uint64_t digest(const Mesh& mesh);

/// What a tessellation keeps. Throws InvalidInput where it is none of this mesh.
const TessellatedGraph& internals_of(const Tessellation& tessellation, const Mesh& mesh);

/// The same figures in input ids and mesh units.
Tessellation describe(TessellatedGraph tessellated);

}  // namespace geolloyd
