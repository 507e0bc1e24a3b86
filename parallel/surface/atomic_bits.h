#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <vector>

#include "core/base/loops.h"

namespace geolloyd {

/// A set of indices that threads may change at once.
class AtomicBits {
 public:
  explicit AtomicBits(std::size_t size) : words_(size / 64 + 1, 0) {}

  [[nodiscard]] std::size_t words() const { return words_.size(); }

  /// Whether it was set before.
  bool set(std::size_t i) {
    const std::uint64_t bit = std::uint64_t{1} << (i % 64);
    if ((relaxed_load(words_[i / 64]) & bit) != 0) return true;
    return (std::atomic_ref(words_[i / 64]).fetch_or(bit, std::memory_order_relaxed) & bit) != 0;
  }
  void reset(std::size_t i) {
    std::atomic_ref(words_[i / 64])
        .fetch_and(~(std::uint64_t{1} << (i % 64)), std::memory_order_relaxed);
  }
  /// Calls visit(i) for each member in a range of words, ascending.
  template <class Visit>
  void for_each(std::size_t begin, std::size_t end, Visit&& visit) {
    for (std::size_t w = begin; w < end; ++w) {
      for (std::uint64_t word = relaxed_load(words_[w]); word != 0; word &= word - 1) {
        visit(64 * w + static_cast<std::size_t>(std::countr_zero(word)));
      }
    }
  }
  void clear() { std::fill(words_.begin(), words_.end(), 0); }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace geolloyd
