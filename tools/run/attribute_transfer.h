#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/executor.h"
#include "core/graph/mesh_graph.h"
#include "core/regions/graph_dual.h"
#include "geolloyd/properties.h"
#include "geolloyd/remesh.h"

namespace geolloyd {

// Properties of a mesh on its remesh. A vertex has those of its place, as values_at
// (geolloyd/remesh.h) has them. Of a triangle four points are looked at, the middles of its
// quarters: it has the mean of what the mesh's triangles closest to them have, or the majority.

Properties transfer_properties(const Mesh& mesh, const Properties& properties, const Remesh& remesh,
                               Executor& executor);

/// The place of a vertex is its seed, or, where it was moved away, the closest point of the mesh.
Properties transfer_properties(const Mesh& mesh, const Properties& properties,
                               const MeshGraph& mesh_graph, const GraphDual& remesh,
                               Executor& executor);

/// Per triangle the value of a property of integers: of triangles or, if there is none, of
/// vertices, the majority at its corners, the smallest where they all differ. Throws InvalidInput
/// where the mesh has no such property.
std::vector<std::uint32_t> label_groups(const Mesh& mesh, const Properties& properties,
                                        const std::string& name);

}  // namespace geolloyd
