#pragma once

#include <cstddef>

namespace geolloyd {

/// The whole number nearest to `x`, which is not negative; of two, the larger.
inline std::size_t round_to_whole(double x) {
  return static_cast<std::size_t>(2 * x + 1) / 2;
}

}  // namespace geolloyd
