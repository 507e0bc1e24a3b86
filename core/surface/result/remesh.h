#pragma once

#include "core/base/executor.h"
#include "core/mesh/mesh_edges.h"
#include "core/surface/cells/surface_engine.h"
#include "geolloyd/remesh.h"

namespace geolloyd {

/// `edges` are the mesh's, which is valid.
Remesh make_remesh(const Mesh& mesh, const MeshEdges& edges, const RemeshOptions& options,
                   const MakeSurfaceEngine& make_engine, Executor& executor = sequential());

/// The same. The edges give their memory back, all but that of the duplicates, before the surface
/// on which sites move is made.
Remesh make_remesh(const Mesh& mesh, MeshEdges&& edges, const RemeshOptions& options,
                   const MakeSurfaceEngine& make_engine, Executor& executor = sequential());

}  // namespace geolloyd
