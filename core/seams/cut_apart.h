#pragma once

#include <cstddef>
#include <vector>

#include "core/base/executor.h"
#include "core/mesh/mesh.h"

namespace geolloyd {

struct CutVertices {
  std::size_t vertices = 0;       ///< how many became several
  std::vector<VertexId> copy_of;  ///< per vertex added: the one that it is a copy of
};

/// Cuts a mesh apart where it is no manifold: a vertex whose triangles, joined across edges of two
/// triangles, form several fans becomes one vertex for each. The fan of the smallest triangle keeps
/// the vertex, copies come last. Then every edge has one or two triangles. All triangles have three
/// vertices, and no two the same. Near-linear.
CutVertices cut_apart(Mesh& mesh, Executor& executor = sequential());

}  // namespace geolloyd
