#pragma once

namespace geolloyd {

/// The cosine of an angle from 0 to 180 degrees, the same bits on every machine.
constexpr double cosine_of_degrees(double degrees) {
  const double x = degrees * (3.141592653589793 / 180) / 16;
  const double square = x * x;
  double cosine = 1;
  for (int i = 12; i > 0; i -= 2) cosine = 1 - cosine * square / (i * (i - 1));
  for (int i = 0; i < 4; ++i) cosine = 2 * cosine * cosine - 1;
  return cosine;
}

}  // namespace geolloyd
