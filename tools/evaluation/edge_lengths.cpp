#include "tools/evaluation/edge_lengths.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace geolloyd {

EdgeLengthRatios summarised(std::vector<double> ratios) {
  std::sort(ratios.begin(), ratios.end());
  const auto at = [&](double share) {
    return ratios[static_cast<std::size_t>(share * static_cast<double>(ratios.size() - 1))];
  };
  const auto near = std::count_if(ratios.begin(), ratios.end(),
                                  [](double r) { return std::abs(r - 1) <= 1.0 / 3; });
  return {at(0.05), at(0.5), at(0.95),
          static_cast<double>(near) / static_cast<double>(ratios.size())};
}

}  // namespace geolloyd
