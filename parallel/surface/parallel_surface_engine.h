#pragma once

#include <memory>

#include "core/base/executor.h"
#include "core/surface/cells/surface_engine.h"

namespace geolloyd {

/// The incremental engine: looks only at vertices and triangles on the borders of cells, and keeps
/// the moments of the triangles within cells by difference.
std::unique_ptr<SurfaceEngine> make_parallel_surface_engine(const FineMesh& mesh,
                                                            Executor& executor);

}  // namespace geolloyd
