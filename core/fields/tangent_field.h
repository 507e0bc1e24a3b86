#pragma once

#include <vector>

#include "core/mesh/mesh.h"
#include "geolloyd/choices.h"

namespace geolloyd {

/// The mean of two spaces. By pairs: of the quarter turns of `b` and of its mirror image, which are
/// all the same metric, the one whose directions are nearest to those of `a` (the first where
/// several are) is averaged with it, each magnitude following its direction. Symmetric as a metric
/// (thesis, section on anisotropy; mirror images, for fields of mixed handedness, are ours). As
/// metrics: metric_mean.h, or by pairs where the directions of one span no plane.
TangentSpace average(const TangentSpace& a, const TangentSpace& b, Averaging averaging);

/// Space of a triangle: by pairs, the average of its first two vertices' with the third's; as
/// metrics, the mean of all three.
TangentSpace triangle_space(const Triangle& triangle, const std::vector<TangentSpace>& vertex_space,
                            Averaging averaging);

}  // namespace geolloyd
