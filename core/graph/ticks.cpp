#include "core/graph/ticks.h"

#include <cmath>
#include <limits>
#include <string>

#include "geolloyd/errors.h"

namespace geolloyd {

// The ticks put aside for rounding are lost in 2^30.
double tick_length_for(const Depth& depth) {
  if (depth.arcs > most_path_arcs) {
    throw InvalidInput("a path of the graph has " + std::to_string(depth.arcs) +
                       " arcs, too many for exact distances: use a coarser mesh");
  }
  const double longest = 2 * depth.length;
  if (!std::isfinite(longest)) {
    throw InvalidInput("a path of the graph is too long for a number: scale the mesh down");
  }
  if (longest == 0) return 1;
  const auto ticks = static_cast<double>(most_length - 2 * depth.arcs - rounding_ticks);
  return std::max(longest / ticks, std::numeric_limits<double>::min());
}

double choose_tick_mass(std::span<const double> masses) {
  const double largest = masses.empty() ? 0 : *std::max_element(masses.begin(), masses.end());
  if (!std::isfinite(largest)) {
    throw InvalidInput("the area of a node is too large for a number: scale the mesh down");
  }
  if (largest == 0) return 1;
  return std::max(largest / most_mass, std::numeric_limits<double>::min());
}

std::uint32_t to_mass_ticks(double mass, double tick) {
  return static_cast<std::uint32_t>(std::min<double>(std::round(mass / tick), most_mass));
}

}  // namespace geolloyd
