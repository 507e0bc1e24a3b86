#pragma once

#include "core/mesh/mesh.h"

namespace geolloyd {

/// Normal of a triangle, twice its area long.
inline Vec3 doubled_area(const Mesh& mesh, const Triangle& t) {
  const Vec3& a = mesh.positions[t[0]];
  return cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
}

}  // namespace geolloyd
