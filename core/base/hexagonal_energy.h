#pragma once

#include <cstddef>

namespace geolloyd {

/// Energy of a regular hexagonal tiling of the plane: so many regions of equal size, which share an
/// area over which a mass is spread evenly. That of one regular hexagon of unit area and unit
/// density is 5 / (18 sqrt 3). Where sizes vary, of the sized area, for both: a cell of inverse
/// sizing r has r^-2 of an even cell's area, and r^4 of its density.
constexpr double hexagonal_energy(double mass, double area, std::size_t regions) {
  return 0.16037507477489604 * mass * area / static_cast<double>(regions);
}

}  // namespace geolloyd
