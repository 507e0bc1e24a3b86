#pragma once

#include <vector>

#include "core/mesh.h"
#include "core/region_surface.h"

namespace geolloyd {

/// Length of the border of each region, mesh units: where it meets others, and the surface's
/// boundary. An edge between two regions is cut where it is as far from the one seed as from the
/// other; the cuts of a triangle are joined by straight lines, three of them at their mean.
std::vector<double> border_lengths(const Mesh& mesh, const RegionSurface& surface);

/// Isoperimetric ratio 4 pi area / perimeter^2: 1 for a disc, 0.907 for a regular hexagon; 0
/// without a perimeter.
double isoperimetric_ratio(double area, double perimeter);

}  // namespace geolloyd
