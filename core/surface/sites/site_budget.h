#pragma once

#include <cstddef>
#include <vector>

#include "core/surface/features/patches.h"

namespace geolloyd {

/// How many sites: free ones, and those on curves.
struct SiteBudget {
  double spacing = 0;
  std::size_t on_curves = 0;
  std::vector<std::size_t> free;  ///< per patch

  [[nodiscard]] std::size_t total() const;
};

/// Counts sites `spacing` apart. A closed patch has 4 at least.
class SiteBudgeter {
 public:
  explicit SiteBudgeter(const DividedSurface& surface) : surface_(surface) {}

  [[nodiscard]] SiteBudget at_spacing(double spacing) const;
  /// `count` sites in all, or the least possible. What rounding leaves goes to the patches in order
  /// of what it took from them.
  [[nodiscard]] SiteBudget of_size(std::size_t count) const;

 private:
  [[nodiscard]] std::vector<double> wanted_free(double spacing) const;

  const DividedSurface& surface_;
};

}  // namespace geolloyd
