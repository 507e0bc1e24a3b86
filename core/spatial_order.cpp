#include "core/spatial_order.h"

#include <algorithm>
#include <utility>

#include "core/bounding_box.h"

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

std::uint64_t morton_code(const Vec3& p, const Vec3& low, double extent) {
  const auto cell = [&](int axis) {
    return static_cast<std::uint64_t>((p[axis] - low[axis]) / extent * most_cells);
  };
  return (spread(cell(0)) << 2) | (spread(cell(1)) << 1) | spread(cell(2));
}

}  // namespace

std::vector<std::uint32_t> spatial_order(std::span<const Vec3> positions) {
  const BoundingBox box = bounding_box(positions);
  const double widest = box.extent().maxCoeff();
  const double extent = widest > 0 ? widest : 1;

  std::vector<std::pair<std::uint64_t, std::uint32_t>> codes;
  codes.reserve(positions.size());
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    codes.emplace_back(morton_code(positions[i], box.low, extent), i);
  }
  std::sort(codes.begin(), codes.end());

  std::vector<std::uint32_t> order;
  order.reserve(codes.size());
  for (const auto& [code, index] : codes) order.push_back(index);
  return order;
}

}  // namespace geolloyd
