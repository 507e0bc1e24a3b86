#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace geolloyd {

/// Which pairs of places are put in order, one after the other, so that `size` entries are sorted:
/// odd-even merges (Batcher 1968). `size` is a power of two.
template <std::size_t size>
class SortingNetwork {
 public:
  static constexpr std::size_t most_pairs = size * size;

  constexpr SortingNetwork() {
    for (std::size_t run = 1; run < size; run *= 2) {
      for (std::size_t step = run; step >= 1; step /= 2) add_merge(run, step);
    }
  }

  std::size_t count = 0;
  std::array<std::array<std::uint8_t, 2>, most_pairs> pair{};

 private:
  constexpr void add_merge(std::size_t run, std::size_t step) {
    for (std::size_t block = step % run; block + step < size; block += 2 * step) {
      for (std::size_t i = block; i < std::min(block + step, size - step); ++i) {
        if (i / (2 * run) != (i + step) / (2 * run)) continue;
        pair[count][0] = static_cast<std::uint8_t>(i);
        pair[count][1] = static_cast<std::uint8_t>(i + step);
        ++count;
      }
    }
  }
};

template <std::size_t size>
inline constexpr SortingNetwork<size> sorting_network{};

/// Sorts no more than `most` numbers, and branches on none of them: such a guess would be wrong
/// every other time.
template <std::size_t most>
void sort_by_network(std::span<std::uint64_t> numbers) {
  const std::size_t size = numbers.size();
  if (size < 2) return;
  std::uint64_t* const data = numbers.data();
  std::array<std::uint64_t, most> e{};
  for (std::size_t i = 0; i < most; ++i) {
    e[i] = data[std::min(i, size - 1)] | (i < size ? std::uint64_t{0} : ~std::uint64_t{0});
  }
  const auto order = [&e](const std::array<std::uint8_t, 2>& pair) {
    const std::uint64_t a = e[pair[0]];
    const std::uint64_t b = e[pair[1]];
    e[pair[0]] = b < a ? b : a;
    e[pair[1]] = b < a ? a : b;
  };
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (order(sorting_network<most>.pair[i]), ...);
  }
  (std::make_index_sequence<sorting_network<most>.count>());
  for (std::size_t i = 0; i < most; ++i) {
    if (i < size) data[i] = e[i];
  }
}

}  // namespace geolloyd
