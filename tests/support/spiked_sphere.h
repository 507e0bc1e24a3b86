#pragma once

#include "core/shapes/shapes.h"

namespace geolloyd {

/// A sphere of radius 1 with a spike half as long at its top.
inline Mesh spiked_sphere() {
  Mesh mesh = icosphere(20'000);
  for (Vec3& p : mesh.positions) {
    const double away = 1 + 40 * (1 - p.z());
    p *= 1 + 0.5 / (away * away);
  }
  return mesh;
}

}  // namespace geolloyd
