#pragma once

#include "core/base/executor.h"
#include "core/mesh/mesh.h"
#include "geolloyd/evaluation.h"

namespace geolloyd {

/// certify_distance() of evaluation.h, for valid meshes with triangles.
SurfaceDistanceBounds certify_distance(Executor& executor, const Mesh& first, const Mesh& second,
                                       double tolerance);

}  // namespace geolloyd
