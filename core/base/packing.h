#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/huge_pages.h"
#include "core/base/loops.h"

namespace geolloyd {

/// Where in one array each of many items puts its output, in the order of the items.
template <class SizeOf>
class Packing {
 public:
  /// `size_of(item)` is the number of elements that an item puts out.
  Packing(Executor& executor, std::size_t items, SizeOf size_of)
      : items_(items), size_of_(std::move(size_of)), before_(items / small_items + 1, 0) {
    parallel_for_ranges(executor, items, small_items,
                        [&](std::size_t begin, std::size_t end, std::size_t) {
                          std::uint64_t sum = 0;
                          for (std::size_t i = begin; i < end; ++i) sum += size_of_(i);
                          before_[begin / small_items] = sum;
                        });
    for (std::uint64_t& before : before_) total_ += std::exchange(before, total_);
  }

  [[nodiscard]] std::uint64_t total() const { return total_; }

  /// Calls write(item, first) for each item that puts out anything; `first` is the index of its
  /// first element.
  template <class Write>
  void for_each(Executor& executor, Write&& write) const {
    if (total_ == 0) return;
    parallel_for_ranges(executor, items_, small_items,
                        [&](std::size_t begin, std::size_t end, std::size_t) {
                          std::uint64_t first = before_[begin / small_items];
                          for (std::size_t i = begin; i < end; ++i) {
                            const std::uint64_t size = size_of_(i);
                            if (size > 0) write(i, first);
                            first += size;
                          }
                        });
  }

 private:
  std::size_t items_;
  SizeOf size_of_;
  std::vector<std::uint64_t> before_;  // per range of items, what those before it put out
  std::uint64_t total_ = 0;
};

/// The items for which `holds(item)`, ascending. `holds` is called once or twice per item.
template <class Predicate>
std::vector<std::uint32_t> pack_indices(Executor& executor, std::size_t items, Predicate&& holds) {
  const Packing packing(executor, items,
                        [&](std::size_t i) { return holds(i) ? std::uint64_t{1} : 0; });
  auto found = huge_vector<std::uint32_t>(packing.total());
  packing.for_each(executor, [&](std::size_t i, std::uint64_t first) {
    found[first] = static_cast<std::uint32_t>(i);
  });
  return found;
}

}  // namespace geolloyd
