#pragma once

#include <cstddef>

namespace geolloyd {

/// Energy of a regular hexagonal tiling of the plane: so many regions of equal size, which share an
/// area over which a mass is spread evenly. 0.160375 is that of one regular hexagon of unit area
/// and unit density, 5 / (18 sqrt 3).
inline double hexagonal_energy(double mass, double area, std::size_t regions) {
  return 0.160375 * mass * area / static_cast<double>(regions);
}

}  // namespace geolloyd
