#pragma once

#include <filesystem>
#include <vector>

#include "core/mesh.h"

namespace geolloyd {

/// An anisotropic metric at one place: a displacement d costs what (tangent_magnitude * tangent.d,
/// bitangent_magnitude * bitangent.d) measures. Directions have length 1, or 0 where the file has
/// no direction. The signs of the directions mean nothing, nor which of the two comes first.
struct TangentSpace {
  Vec3 tangent;
  Vec3 bitangent;
  double tangent_magnitude;
  double bitangent_magnitude;
};

/// The mean of two spaces: of the four quarter turns of `b`, the one whose directions are nearest
/// to those of `a` (the first where several are) is averaged with it, each magnitude following its
/// direction. Symmetric as a metric (thesis, section on anisotropy; its program's faults avoided).
TangentSpace average(const TangentSpace& a, const TangentSpace& b);

/// One space per vertex, from a .vfield file: any header lines, then the line of column names "k1
/// k2 k1v_x ...", then eight numbers per vertex (two magnitudes, tangent, bitangent). Throws
/// InvalidInput naming the line where something is malformed, missing or too much.
std::vector<TangentSpace> read_tangent_field(const std::filesystem::path& path,
                                             std::size_t vertex_count);

/// Space of each triangle: the average of its first two vertices' with the third's.
std::vector<TangentSpace> triangle_spaces(const Mesh& mesh,
                                          const std::vector<TangentSpace>& vertex_space);

}  // namespace geolloyd
