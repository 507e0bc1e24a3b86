#pragma once

#include <functional>

#include "core/mesh/mesh_edges.h"
#include "geolloyd/remesh.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

/// `edges` are the mesh's, which is valid. Before the surface is made on which sites move,
/// `release_edges` is called, if there is one: of the edges only the duplicates are needed from
/// then on.
Remesh make_remesh(const Mesh& mesh, const MeshEdges& edges, const RemeshOptions& options,
                   Runtime& runtime, const std::function<void()>& release_edges = {});

}  // namespace geolloyd
