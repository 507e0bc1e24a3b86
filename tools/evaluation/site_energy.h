#pragma once

#include <span>

#include "core/base/executor.h"
#include "core/base/vec3.h"

namespace geolloyd {

/// Euclidean energy of `sites`, at least one: sum over `points` of mass * squared distance to the
/// nearest site. The same for any number of threads.
double site_energy(Executor& executor, std::span<const Vec3> points, std::span<const double> mass,
                   std::span<const Vec3> sites);

}  // namespace geolloyd
