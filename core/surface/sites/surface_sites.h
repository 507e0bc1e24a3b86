#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vec3.h"
#include "geolloyd/types.h"

namespace geolloyd {

/// Sites on a surface, unit frame. Those on curves come first, and are fixed.
struct SurfaceSites {
  std::vector<Vec3> positions;
  std::vector<std::uint32_t> patch;    ///< per site: its own, or no_id on a curve
  std::vector<std::uint8_t> is_fixed;  ///< per site: not 0 where it must not move
  std::size_t on_curves = 0;           ///< how many are on curves

  SurfaceSites() = default;
  /// Those on curves.
  explicit SurfaceSites(std::span<const Vec3> curve_positions)
      : positions(curve_positions.begin(), curve_positions.end()),
        patch(positions.size(), no_id),
        is_fixed(positions.size(), 1),
        on_curves(positions.size()) {}

  [[nodiscard]] std::size_t size() const { return positions.size(); }
  void add(const Vec3& position, std::uint32_t of_patch) {
    positions.push_back(position);
    patch.push_back(of_patch);
    is_fixed.push_back(0);
  }
};

}  // namespace geolloyd
