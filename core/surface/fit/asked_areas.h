#pragma once

#include <vector>

#include "core/surface/fit/moving_remesh.h"

namespace geolloyd {

/// Areas that triangles of a remesh are to have, unit frame.
struct AskedAreas {
  double side = 0;                ///< of an equilateral triangle of the mean area
  std::vector<double> at_vertex;  ///< of a triangle, its corners' mean
};

/// The mean; where sizes vary, as they are, smoothed.
AskedAreas find_asked_areas(const MovingRemesh& remesh, bool is_graded);

}  // namespace geolloyd
