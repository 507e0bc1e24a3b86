#pragma once

#include <numeric>
#include <vector>

#include "core/base/types.h"

namespace geolloyd {

/// Items with integer weights that change: O(1) to change one, O(n / 1024 + 1024) to find the item
/// at a place in their running sum. Exact, so that a draw cannot depend on the order of changes.
class WeightedSampler {
 public:
  explicit WeightedSampler(std::size_t size)
      : weight_(size, 0), block_sum_((size + block_size - 1) / block_size, 0) {}

  void set(std::size_t item, Uint128 weight) {
    block_sum_[item / block_size] += weight - weight_[item];
    weight_[item] = weight;
  }

  [[nodiscard]] Uint128 total() const {
    return std::accumulate(block_sum_.begin(), block_sum_.end(), Uint128{0});
  }

  /// The item in whose weight `place` falls; `place` < total().
  [[nodiscard]] std::size_t at(Uint128 place) const {
    std::size_t block = 0;
    while (place >= block_sum_[block]) place -= block_sum_[block++];
    std::size_t item = block * block_size;
    while (place >= weight_[item]) place -= weight_[item++];
    return item;
  }

 private:
  static constexpr std::size_t block_size = 1024;

  std::vector<Uint128> weight_;
  std::vector<Uint128> block_sum_;
};

}  // namespace geolloyd
