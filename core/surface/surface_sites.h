#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vec3.h"
#include "geolloyd/types.h"

namespace geolloyd {

/// Sites on a surface, unit frame. Those on the boundary come first, and stay where they are.
struct SurfaceSites {
  std::vector<Vec3> positions;
  std::vector<std::uint32_t> part;  ///< per site: of the surface
  std::vector<std::uint8_t> stays;  ///< per site: not 0 where it must not move
  std::size_t outer = 0;            ///< how many are on the boundary

  SurfaceSites() = default;
  /// Those on the boundary.
  SurfaceSites(std::span<const Vec3> outer_positions, std::span<const std::uint32_t> outer_part)
      : positions(outer_positions.begin(), outer_positions.end()),
        part(outer_part.begin(), outer_part.end()),
        stays(positions.size(), 1),
        outer(positions.size()) {}

  [[nodiscard]] std::size_t size() const { return positions.size(); }
  void add(const Vec3& position, std::uint32_t of_part) {
    positions.push_back(position);
    part.push_back(of_part);
    stays.push_back(0);
  }
};

}  // namespace geolloyd
