#pragma once

#include <span>
#include <vector>

#include "core/base/executor.h"
#include "core/mesh/mesh.h"
#include "geolloyd/remesh.h"

namespace geolloyd {

/// The points of the surface that are closest to these. Throws InvalidInput where it has no
/// triangle.
std::vector<SurfacePoint> closest_places(const Mesh& mesh, std::span<const Vec3> points,
                                         Executor& executor);

}  // namespace geolloyd
