#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/base/bucketing.h"
#include "core/base/executor.h"
#include "core/mesh/mesh_edges.h"

namespace geolloyd {

// What meets at each vertex of a mesh. Lists are ascending; all take time in proportion to the
// mesh. A list takes 4 bytes per entry and per vertex, so each is made where it is needed and kept
// no longer: three entries a triangle, two an edge.

/// The triangles at each vertex. One that names a vertex twice is there twice.
Bucketed<TriangleId> triangles_at_vertices(std::size_t vertices,
                                           std::span<const Triangle> triangles,
                                           Executor& executor = sequential());

/// The corners at each vertex of triangles with three vertices: its fans.
Bucketed<CornerId> corners_at_vertices(const Mesh& mesh, Executor& executor = sequential());

/// The edges at each vertex, by their places in `edges`.
Bucketed<std::uint32_t> edges_at_vertices(std::size_t vertices, const MeshEdges& edges,
                                          Executor& executor = sequential());

}  // namespace geolloyd
