#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/base/executor.h"
#include "core/surface/cells/surface_engine.h"

namespace geolloyd {

struct DescentOptions {
  std::span<const std::uint8_t> is_fixed;  ///< per site: not 0 where it must not move
  std::size_t most_iterations = 0;
  double longest_move = 0;  ///< of a site in one step, unit frame, where the inverse sizing is 1
  std::span<const double> inverse_sizing;  ///< per site; empty: 1
  double least_gain = 0;  ///< ends where ten iterations lower the energy by a smaller share
  /// Told the energy and the sites after each iteration; false ends the descent.
  std::function<bool(double energy, std::span<const Vec3> sites)> keep_going;
};

/// Moves `sites` downhill in energy: the sum over cells of the integral of |x - site|^2, whose
/// gradient is 2 m (site - centroid), m the cell's area. L-BFGS with 7 pairs, preconditioned by
/// 1 / (2 m), or in a metric by the inverse of twice its integral, with a backtracking line search
/// (Nocedal and Wright 2006, 7.2 and 3.1; for CVT: Liu et al. 2009). The energy never rises.
/// Returns that of the result. The engine's labels are those of the result.
double descend(const FineMesh& mesh, SurfaceEngine& engine, std::vector<Vec3>& sites,
               const DescentOptions& options, Executor& executor = sequential());

}  // namespace geolloyd
