#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/huge_pages.h"
#include "core/base/loops.h"

namespace geolloyd {

/// Union-find with path halving (Tarjan, van Leeuwen 1984). The root of a set is its smallest
/// member, so that the root does not depend on the order of unions. The threads of `executor` may
/// use all members at once.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size, const Executor& executor = sequential())
      : is_shared_(executor.threads() > 1), parent_(huge_vector<std::uint32_t>(size)) {
    for (std::size_t i = 0; i < size; ++i) parent_[i] = static_cast<std::uint32_t>(i);
  }

  std::uint32_t find(std::uint32_t x) {
    for (std::uint32_t up = relaxed_load(parent_[x]); up != x; up = relaxed_load(parent_[x])) {
      const std::uint32_t further = relaxed_load(parent_[up]);
      if (further != up) relaxed_store(parent_[x], further);
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
      if (hang(a, b)) return true;
    }
  }

 private:
  // One thread alone needs no locked instruction.
  bool hang(std::uint32_t root, std::uint32_t below) {
    if (is_shared_) return compare_exchange(parent_[root], root, below);
    parent_[root] = below;
    return true;
  }

  bool is_shared_;
  std::vector<std::uint32_t> parent_;  // of a root, itself; of others, a smaller member
};

}  // namespace geolloyd
