#pragma once

#include <cstddef>
#include <vector>

#include "core/surface/outer_chains.h"
#include "core/surface/surface_input.h"

namespace geolloyd {

/// What is to be known of a connected part of a surface to say how many sites it gets.
struct SurfacePart {
  double area = 0;                        ///< unit frame
  std::int64_t euler_characteristic = 0;  ///< pinholes closed
  bool is_closed = true;
};

std::vector<SurfacePart> find_surface_parts(const SurfaceInput& input, const OuterChains& outer);

/// How many free sites, and how many on the boundary.
struct SiteBudget {
  double spacing = 0;
  std::size_t outer = 0;
  std::vector<std::size_t> free;  ///< per part

  [[nodiscard]] std::size_t total() const;
};

/// Counts sites `spacing` apart. A closed part has 4 at least.
class SiteBudgeter {
 public:
  SiteBudgeter(const SurfaceInput& input, const OuterChains& outer);

  [[nodiscard]] SiteBudget at_spacing(double spacing) const;
  /// `count` sites in all, or the least possible. What rounding leaves goes to the parts in order
  /// of what it took from them.
  [[nodiscard]] SiteBudget of_size(std::size_t count) const;

 private:
  [[nodiscard]] std::vector<double> wanted_free(double spacing) const;

  const SurfaceInput& input_;
  const OuterChains& outer_;
  std::vector<SurfacePart> parts_;
};

}  // namespace geolloyd
