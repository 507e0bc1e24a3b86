#pragma once

#include <array>
#include <cmath>

namespace geolloyd {

/// Cosine and sine of the direction in which the form with the matrix (h + p, q; q, h - p) is
/// largest, whatever h: its value there is h + sqrt(p^2 + q^2). (1, 0) where p and q are 0. By the
/// formulas of half angles, with the one that cancels nothing.
inline std::array<double, 2> principal_direction(double p, double q) {
  const double radius = std::sqrt(p * p + q * q);
  if (!(radius > 0)) return {1, 0};
  const double larger = std::sqrt((1 + std::abs(p) / radius) / 2);
  const double smaller = q / radius / (2 * larger);
  return p >= 0 ? std::array{larger, smaller} : std::array{smaller, larger};
}

}  // namespace geolloyd
