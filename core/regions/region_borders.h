#pragma once

#include <vector>

#include "core/dual/region_surface.h"
#include "core/mesh/mesh.h"

namespace geolloyd {

/// Length of the border of each region, mesh units: where it meets others, and the surface's
/// boundary. An edge between two regions is cut where it is as far from the one seed as from the
/// other, and cuts of one triangle are joined by straight lines, three of them at their mean. Graph
/// distances let such a line zigzag about its course by less than an edge, which would make it
/// longer by a sixth: it is smoothed first.
std::vector<double> border_lengths(const Mesh& mesh, const RegionSurface& surface);

/// Isoperimetric ratio 4 pi area / perimeter^2: 1 for a disc, 0.907 for a regular hexagon; 0
/// without a perimeter.
double isoperimetric_ratio(double area, double perimeter);

}  // namespace geolloyd
