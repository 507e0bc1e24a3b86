#pragma once

#include <vector>

#include "core/mesh/mesh.h"

namespace geolloyd {

/// An anisotropic metric at one place: a displacement d costs what (tangent_magnitude * tangent.d,
/// bitangent_magnitude * bitangent.d) measures. Directions have length 1, or 0 where the file has
/// no direction. The signs of the directions mean nothing, nor which of the two comes first.
struct TangentSpace {
  Vec3 tangent;
  Vec3 bitangent;
  double tangent_magnitude = 1;
  double bitangent_magnitude = 1;
};

/// The mean of two spaces: of the quarter turns of `b` and of its mirror image, which are all the
/// same metric, the one whose directions are nearest to those of `a` (the first where several are)
/// is averaged with it, each magnitude following its direction. Symmetric as a metric (thesis,
/// section on anisotropy; mirror images, for fields of mixed handedness, are ours).
TangentSpace average(const TangentSpace& a, const TangentSpace& b);

/// Space of a triangle: the average of its first two vertices' with the third's.
TangentSpace triangle_space(const Triangle& triangle,
                            const std::vector<TangentSpace>& vertex_space);

}  // namespace geolloyd
