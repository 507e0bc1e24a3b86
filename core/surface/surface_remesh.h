#pragma once

#include "core/base/executor.h"
#include "core/mesh/mesh_edges.h"
#include "core/surface/surface_engine.h"
#include "geolloyd/remesh.h"

namespace geolloyd {

/// `edges` are the mesh's, which is valid.
SurfaceRemesh make_surface_remesh(const Mesh& mesh, const MeshEdges& edges,
                                  const SurfaceRemeshOptions& options,
                                  const MakeSurfaceEngine& make_engine,
                                  Executor& executor = sequential());

}  // namespace geolloyd
