#pragma once

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "core/base/bounding_box.h"
#include "core/base/grouping.h"
#include "core/graph/spatial_order.h"

namespace geolloyd {

/// A cube of 2^21 cells an axis.
struct MortonGrid {
  Vec3 low;
  double extent;

  explicit MortonGrid(const BoundingBox& box);
  /// Of the cell that holds `p`: 63 bits.
  [[nodiscard]] std::uint64_t code(const Vec3& p) const;
};

/// spatial_order of position_of(i) for i < count.
template <class Executor, class PositionOf>
std::vector<std::uint32_t> spatial_order_on(Executor& executor, std::size_t count,
                                            PositionOf&& position_of) {
  const MortonGrid grid(bounding_box_on(executor, count, position_of));
  Buffer<std::uint64_t> codes(count);
  for_items(executor, count, small_items,
            [&](std::size_t i) { codes[i] = grid.code(position_of(i)); });

  // Coarse cells first: what is left to sort then fits into the nearest cache.
  using Entry = std::pair<std::uint64_t, std::uint32_t>;
  const auto coarse_bits = std::min<std::size_t>(std::bit_width(count), 18);
  Groups<Entry> cells = group_items<Entry>(
      executor, std::size_t{1} << coarse_bits, count, [&](std::size_t i, auto&& put) {
        put(codes[i] >> (63 - coarse_bits), Entry(codes[i], static_cast<std::uint32_t>(i)));
      });
  std::vector<std::uint32_t> order(count);
  for_items(executor, cells.size(), small_items, [&](std::size_t c) {
    std::sort(cells[c].begin(), cells[c].end());
    for (const Entry& entry : cells[c]) {
      order[static_cast<std::size_t>(&entry - cells.entry.data())] = entry.second;
    }
  });
  return order;
}

}  // namespace geolloyd
