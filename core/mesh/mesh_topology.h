#pragma once

#include <cstddef>

#include "core/base/executor.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_edges.h"
#include "geolloyd/quality.h"

namespace geolloyd {

/// Of the triangles that have three vertices, and of the vertices they name. O(triangles).
MeshTopology find_topology(const Mesh& mesh, const MeshEdges& edges,
                           Executor& executor = sequential());

}  // namespace geolloyd
