#pragma once

#include <span>

#include "geolloyd/choices.h"

namespace geolloyd {

/// True where the two directions span a plane.
bool has_plane(const TangentSpace& space);

/// The mean of one to four spaces as metrics M = k1^2 t t^T + k2^2 b b^T: it does not depend on
/// their order, but for rounding, nor on how the directions are swapped or negated. All must have a
/// plane; planes are turned into that of the mean normal. The result has the principal directions.
///
/// There the roots of the metrics are added: matrices of one size, (k1 + k2) / 2, and of one
/// stretch, (k1 - k2) / 2, which points along twice the angle of the larger direction. The mean's
/// size is the mean of sizes. The mean of stretches is too short where directions differ (Dryden et
/// al. 2009 and Collard et al. 2014, who call that swelling). It points the right way, and is c <=
/// 1 times as long as stretches are on average; we make it 2 - c times as long. So a space that
/// turns by a small angle d keeps its shape up to d^4, two at a right angle become isotropic, and
/// everything between is continuous. A space without stretch has no say in the direction.
TangentSpace metric_mean(std::span<const TangentSpace> spaces);

}  // namespace geolloyd
