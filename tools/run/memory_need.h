#pragma once

#include <cstdint>

#include "core/formats/mesh_io.h"
#include "core/graph/mesh_graph.h"
#include "core/mesh/mesh_edges.h"
#include "geolloyd/remesh.h"
#include "tools/system/memory_estimate.h"

namespace geolloyd {

/// Vertices, triangles and properties.
WorkSize size_of(const LoadedMesh& loaded);

// The bytes that a command will hold at most. `size` is size_of() the mesh with what the command is
// asked for; what follows from graph, options and threads is added here.

/// Of `relax` and its relatives, with `size.sites` seeds. Throws InvalidInput where the graph has
/// more arcs than there are ids.
std::uint64_t memory_to_relax(const Mesh& mesh, const MeshEdges& edges, GraphKind kind,
                              WorkSize size, Executor& executor);

/// Of a remesh with `size.sites` vertices. `area` is that of the mesh.
std::uint64_t memory_to_remesh(const Mesh& mesh, const MeshEdges& edges, double area,
                               const RemeshOptions& options, WorkSize size, Executor& executor);

}  // namespace geolloyd
