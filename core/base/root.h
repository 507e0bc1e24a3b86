#pragma once

#include <algorithm>
#include <cmath>

namespace geolloyd {

/// The root of `x` > 0 of a degree from 1 to 8: within 2 units in the last place, and the same on
/// every machine. Newton's iteration comes down to it from above, on the number between 1 and
/// 2^degree that is left when a power of 2^degree is taken out, which is exact.
inline double root(double x, int degree) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);  // in [1/2, 1)
  int whole = (exponent - 1) / degree;
  if (whole * degree > exponent - 1) --whole;
  const double rest = std::ldexp(fraction, exponent - whole * degree);
  double result = std::min(2.0, 1 + (rest - 1) / degree);
  while (true) {
    double power = 1;
    for (int i = 1; i < degree; ++i) power *= result;
    const double next = ((degree - 1) * result + rest / power) / degree;
    if (!(next < result)) return std::ldexp(result, whole);
    result = next;
  }
}

}  // namespace geolloyd
