#include "core/mesh/spatial_order.h"

namespace geolloyd {
namespace {

constexpr double most_cells = (1 << 21) - 1;

// Moves bit i of the low 21 bits to bit 3i.
std::uint64_t spread(std::uint64_t x) {
  x = (x | (x << 32)) & 0x001f00000000ffffu;
  x = (x | (x << 16)) & 0x001f0000ff0000ffu;
  x = (x | (x << 8)) & 0x100f00f00f00f00fu;
  x = (x | (x << 4)) & 0x10c30c30c30c30c3u;
  return (x | (x << 2)) & 0x1249249249249249u;
}

}  // namespace

MortonGrid::MortonGrid(const BoundingBox& box) : low(box.low), extent(box.extent().maxCoeff()) {
  if (!(extent > 0)) extent = 1;
}

std::uint64_t MortonGrid::code(const Vec3& p) const {
  const auto cell = [&](int axis) {
    return static_cast<std::uint64_t>((p[axis] - low[axis]) / extent * most_cells);
  };
  return (spread(cell(0)) << 2) | (spread(cell(1)) << 1) | spread(cell(2));
}

}  // namespace geolloyd
