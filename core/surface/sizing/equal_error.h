#pragma once

#include <span>
#include <vector>

namespace geolloyd {

/// Of a remesh, about one of its vertices: the length of edges, and how far the surface is.
struct MeasuredCell {
  double length = 0;
  double distance = 0;
};

/// Per cell: how long edges are to be there so that distances are alike, and so many cells cover
/// the surface. Where the surface is smooth, distance is in proportion to length^2. At a fold or a
/// tip that is sharp beside an edge, it is half an edge and in proportion to the length itself. So
/// distance = length^2 / (2 (length + g)), where g is what the measured distance makes of it. Edges
/// become at most a fifth longer, as cells without any distance would become huge, and at most four
/// times shorter than those of evenly spread cells.
std::vector<double> lengths_of_equal_error(std::span<const MeasuredCell> cells, double count);

}  // namespace geolloyd
