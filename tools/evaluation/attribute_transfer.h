#pragma once

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

}  // namespace geolloyd
