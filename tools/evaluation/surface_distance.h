#pragma once

#include <cstddef>

#include "core/mesh/mesh.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {

/// How far points of a surface are from another, mesh units.
struct DistanceFigures {
  double mean = 0;
  double rms = 0;      ///< root of the mean square
  double largest = 0;  ///< one-sided Hausdorff distance, as far as samples and vertices find it
};

/// How far two surfaces are apart (Cignoni et al. 1998, Metro). Mean and RMS are those of samples
/// spread evenly by area, the largest is that of the samples and all vertices of triangles.
struct SurfaceDistance {
  DistanceFigures from_first;  ///< of points of the first surface to the second
  DistanceFigures from_second;

  /// The larger of both directions, figure by figure.
  [[nodiscard]] DistanceFigures two_sided() const;
};

/// With `samples` >= 1 on each surface. The same for any number of threads. Throws InvalidInput
/// where one of them has no area.
SurfaceDistance measure_distance(Scheduler& scheduler, const Mesh& first, const Mesh& second,
                                 std::size_t samples);

}  // namespace geolloyd
