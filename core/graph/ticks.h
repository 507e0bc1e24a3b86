#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/graph/graph.h"

namespace geolloyd {

/// How deep breadth-first trees are: the largest of all components.
struct Depth {
  double length = 0;  ///< mesh units
  std::size_t arcs = 0;
};

/// Rounding adds a tick at most to every arc, and two ways to the root bound a path: with so many
/// arcs that may be half of all ticks there are.
inline constexpr std::size_t rounding_ticks = 64;  ///< what the sum of a path's lengths is off by
inline constexpr std::size_t most_path_arcs = (most_length / 2 - rounding_ticks) / 2;

/// The finest tick that Graph allows. Throws InvalidInput where a path has too many arcs, or is so
/// long that its length is not finite.
double tick_length_for(const Depth& depth);
/// The largest mass becomes most_mass ticks. Throws InvalidInput where a mass is not finite.
double choose_tick_mass(std::span<const double> masses);

/// An arc longer than every shortest path is on none, so its length may be cut to fit. The double
/// just below one half, which alone would not round to nearest this way, is less than a tick.
inline std::uint32_t to_length_ticks(double length, double tick) {
  return static_cast<std::uint32_t>(std::clamp<double>(length / tick + 0.5, 1, most_length));
}
std::uint32_t to_mass_ticks(double mass, double tick);

}  // namespace geolloyd
