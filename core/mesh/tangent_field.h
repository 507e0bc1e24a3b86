#pragma once

#include <vector>

#include "core/mesh/mesh.h"
#include "geolloyd/choices.h"

namespace geolloyd {

/// The mean of two spaces: of the quarter turns of `b` and of its mirror image, which are all the
/// same metric, the one whose directions are nearest to those of `a` (the first where several are)
/// is averaged with it, each magnitude following its direction. Symmetric as a metric (thesis,
/// section on anisotropy; mirror images, for fields of mixed handedness, are ours).
TangentSpace average(const TangentSpace& a, const TangentSpace& b);

/// Space of a triangle: the average of its first two vertices' with the third's.
TangentSpace triangle_space(const Triangle& triangle,
                            const std::vector<TangentSpace>& vertex_space);

}  // namespace geolloyd
