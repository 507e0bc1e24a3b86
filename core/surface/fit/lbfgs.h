#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/base/vec3.h"

namespace geolloyd {

/// A function of many points, and its gradient there.
using PointsFunction = std::function<double(const std::vector<Vec3>&, std::vector<Vec3>&)>;

struct PointDescent {
  std::span<const double> preconditioner;  ///< per point: the inverse of how stiff it is
  double longest_step = 0;                 ///< of a point in an iteration
  int iterations = 0;
  double least_gain = 1e-6;  ///< of an iteration, over the function: else it is the last
  std::function<bool()> keep_going = {};  ///< asked after each iteration, if there is one
};

/// Moves points downhill by L-BFGS (Liu and Nocedal 1989) with backtracking. Sums are made in the
/// order of points.
void descend(const PointsFunction& function, const PointDescent& options, std::vector<Vec3>& x);

}  // namespace geolloyd
