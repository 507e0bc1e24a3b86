#pragma once

#include <vector>

namespace geolloyd {

/// Lengths of a remesh's edges, each over what it was to be.
struct EdgeLengthRatios {
  double fifth = 0;  ///< percentile
  double median = 0;
  double ninety_fifth = 0;    ///< percentile
  double share_in_third = 0;  ///< of edges whose ratio is from 2/3 to 4/3
};

/// Of at least one.
EdgeLengthRatios summarised(std::vector<double> ratios);

}  // namespace geolloyd
