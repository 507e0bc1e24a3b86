#pragma once

#include <cstddef>
#include <vector>

#include "core/base/executor.h"
#include "core/mesh/mesh.h"
#include "tools/render/ray_caster.h"
#include "tools/render/view.h"

namespace geolloyd {

/// Rays through a regular grid of points, several a pixel, stored row by row.
struct SampleGrid {
  static constexpr int per_side = 3;  ///< of a pixel

  Size size;  ///< pixels

  [[nodiscard]] int columns() const { return size.width * per_side; }
  [[nodiscard]] int rows() const { return size.height * per_side; }
  [[nodiscard]] std::size_t count() const { return index(0, rows()); }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns()) +
           static_cast<std::size_t>(column);
  }
  /// Of a sample's column or row, in pixels.
  static double place(int column) { return (column + 0.5) / per_side; }
};

enum class Shading { smooth, flat };

/// A mesh as a camera sees it: made once, for all panels and frames with that view.
struct Scene {
  Camera camera;
  SampleGrid grid;
  Mesh mesh;                 ///< in the space of the picture (view.h)
  std::vector<RayHit> hit;   ///< per sample
  std::vector<float> light;  ///< per sample; 1 is full
};

/// Smooth shading keeps edges that are sharper than some 40 degrees.
Scene make_scene(const Mesh& mesh, const Camera& camera, Shading shading, Executor& executor);

}  // namespace geolloyd
