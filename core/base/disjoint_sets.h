#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/executor.h"

namespace geolloyd {

/// Union-find, halving paths. The root of a set is its smallest member, so that it is the same
/// whatever the order of unions. All members may be used at once.
template <class Executor>
class DisjointSets {
 public:
  DisjointSets(Executor& executor, std::size_t size) : executor_(executor), parent_(size) {
    for (std::size_t i = 0; i < size; ++i) parent_[i] = static_cast<std::uint32_t>(i);
  }

  std::uint32_t find(std::uint32_t x) {
    for (std::uint32_t up = parent(x); up != x; up = parent(x)) {
      const std::uint32_t further = parent(up);
      if (further != up) store(executor_, parent_[x], further);
      x = further;
    }
    return x;
  }

  /// True where the two were apart.
  bool unite(std::uint32_t a, std::uint32_t b) {
    while (true) {
      a = find(a);
      b = find(b);
      if (a == b) return false;
      if (a < b) std::swap(a, b);
      if (replace(executor_, parent_[a], a, b)) return true;
    }
  }

 private:
  std::uint32_t parent(std::uint32_t x) { return load(executor_, parent_[x]); }

  Executor& executor_;
  std::vector<std::uint32_t> parent_;  // of a root, itself; of others, a smaller member
};

}  // namespace geolloyd
