#pragma once

#include <limits>
#include <span>

#include "core/base/bounding_box.h"
#include "core/mesh/mesh.h"

namespace geolloyd {

/// Moves and scales positions into a cube of side 1 about the origin: Embree has 24 bits only.
struct UnitFrame {
  Vec3 middle;
  double scale;  ///< from mesh units

  explicit UnitFrame(std::span<const Vec3> positions) {
    const BoundingBox box = bounding_box(positions);
    const double widest = box.extent().maxCoeff();
    middle = box.middle();
    // A denormal extent has no reciprocal; no extent is as good.
    scale = widest >= std::numeric_limits<double>::min() ? 1 / widest : 1;
  }

  [[nodiscard]] Vec3 operator()(const Vec3& p) const { return (p - middle) * scale; }

  [[nodiscard]] Mesh operator()(Mesh mesh) const {
    for (Vec3& p : mesh.positions) p = (*this)(p);
    return mesh;
  }
};

}  // namespace geolloyd
