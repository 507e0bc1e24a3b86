#include "core/surface/sites/site_budget.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/rounding.h"
#include "core/surface/sizing/sizing.h"

namespace geolloyd {

std::size_t SiteBudget::total() const {
  return std::accumulate(free.begin(), free.end(), on_curves);
}

// Triangles of an edge of `spacing` cover a patch; Euler's formula gives their vertices.
std::vector<double> SiteBudgeter::wanted_free(double spacing) const {
  constexpr double least_closed = 4;
  const std::vector<Patch>& patches = surface_.patches.patches;
  std::vector<double> wanted;
  wanted.reserve(patches.size());
  for (const Patch& patch : patches) {
    wanted.push_back(sites_at(patch.area, spacing) +
                     static_cast<double>(patch.euler_characteristic));
  }
  for (std::size_t i = 0; i < surface_.curves.curves.size(); ++i) {
    const auto intervals = static_cast<double>(surface_.curves.curves[i].intervals(spacing));
    for (const PatchId p : surface_.patches.beside[i]) wanted[p] -= intervals / 2;
  }
  for (std::size_t p = 0; p < patches.size(); ++p) {
    wanted[p] = std::max(wanted[p], patches[p].is_closed ? least_closed : 0);
  }
  return wanted;
}

SiteBudget SiteBudgeter::at_spacing(double spacing) const {
  SiteBudget budget{spacing, surface_.curves.corners.size(), {}};
  for (const FeatureCurve& curve : surface_.curves.curves) {
    budget.on_curves += curve.intervals(spacing) - (curve.is_loop ? 0 : 1);
  }
  for (const double wanted : wanted_free(spacing)) {
    budget.free.push_back(round_to_whole(wanted));
  }
  return budget;
}

SiteBudget SiteBudgeter::of_size(std::size_t count) const {
  double low = 1e-9;
  double high = 16;
  for (int i = 0; i < 200 && low < high * (1 - 1e-12); ++i) {
    const double middle = std::sqrt(low * high);
    (at_spacing(middle).total() > count ? low : high) = middle;
  }
  SiteBudget budget = at_spacing(high);
  const std::vector<double> wanted = wanted_free(high);
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return wanted[a] - static_cast<double>(budget.free[a]) >
           wanted[b] - static_cast<double>(budget.free[b]);
  });
  const std::size_t total = budget.total();
  for (std::size_t i = 0; total + i < count; ++i) ++budget.free[order[i % order.size()]];
  return budget;
}

}  // namespace geolloyd
