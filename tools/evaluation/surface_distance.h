#pragma once

#include <cstddef>

#include "core/base/executor.h"
#include "core/mesh/mesh.h"
#include "geolloyd/evaluation.h"

namespace geolloyd {

/// With `samples` >= 1 on each surface. The same for any number of threads. Throws InvalidInput
/// where one of them has no area.
SurfaceDistance measure_distance(Executor& executor, const Mesh& first, const Mesh& second,
                                 std::size_t samples);

}  // namespace geolloyd
