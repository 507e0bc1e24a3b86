#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/bounding_box.h"
#include "core/base/bucketing.h"

namespace geolloyd {

/// A cube of 2^21 cells an axis.
struct MortonGrid {
  Vec3 low;
  double extent;

  explicit MortonGrid(const BoundingBox& box);
  /// Of the cell that holds `p`: 63 bits.
  [[nodiscard]] std::uint64_t code(const Vec3& p) const;
};

/// Indices i < count of the positions position_of(i), all in the grid's cube, along a Morton
/// (Z-order) curve through it; equal cells in order of index. What is near in space comes to lie
/// near in memory.
template <class PositionOf>
std::vector<std::uint32_t> spatial_order(const MortonGrid& grid, std::size_t count,
                                         PositionOf&& position_of,
                                         Executor& executor = sequential()) {
  Buffer<std::uint64_t> codes(count);
  parallel_for(executor, count, small_items,
               [&](std::size_t i) { codes[i] = grid.code(position_of(i)); });

  // Coarse cells first: what is left to sort then fits into the nearest cache.
  using Entry = std::pair<std::uint64_t, std::uint32_t>;
  const auto coarse_bits = std::min<std::size_t>(std::bit_width(count), 18);
  Bucketed<Entry> cells = bucket_sort<Entry>(
      executor, std::size_t{1} << coarse_bits, count, [&](std::size_t i, auto&& put) {
        put(codes[i] >> (63 - coarse_bits), Entry(codes[i], static_cast<std::uint32_t>(i)));
      });
  auto order = huge_vector<std::uint32_t>(count);
  parallel_for(executor, cells.size(), small_items, [&](std::size_t c) {
    std::sort(cells[c].begin(), cells[c].end());
    for (const Entry& entry : cells[c]) {
      order[static_cast<std::size_t>(&entry - cells.entry.data())] = entry.second;
    }
  });
  return order;
}

/// In the grid of their bounding cube.
template <class PositionOf>
std::vector<std::uint32_t> spatial_order(std::size_t count, PositionOf&& position_of,
                                         Executor& executor = sequential()) {
  return spatial_order(MortonGrid(bounding_box(count, position_of, executor)), count, position_of,
                       executor);
}

inline std::vector<std::uint32_t> spatial_order(std::span<const Vec3> positions) {
  return spatial_order(positions.size(), [&](std::size_t i) { return positions[i]; });
}

}  // namespace geolloyd
