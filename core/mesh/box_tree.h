#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/mesh/spatial_order.h"

namespace geolloyd {

/// Finds which of many boxes overlap another one, or each other: all that do, and some that nearly
/// do. Boxes are in leaves of eight along a Morton curve, and each level above has pairs of what is
/// below.
class BoxTree {
 public:
  /// box_of(i) for i < count.
  template <class BoxOf>
  BoxTree(std::size_t count, BoxOf&& box_of, Executor& executor = sequential())
      : leaf_((count + leaf_size - 1) / leaf_size) {
    const BoundingBox all = bounding_box_of(count, box_of, executor);
    frame_ = Frame(all);
    number_ = spatial_order(
        MortonGrid(all), count,
        [&](std::size_t i) {
          const GrowingBox box = box_of(i);
          return Vec3(box.low / 2 + box.high / 2);
        },
        executor);
    parallel_for(executor, leaf_.size(), small_items / leaf_size, [&](std::size_t leaf) {
      for (std::size_t i = 0; i < leaf_size; ++i) {
        const std::size_t n = leaf * leaf_size + i;
        leaf_[leaf].set(i, n < count ? frame_(box_of(number_[n])) : Box{});
      }
    });
    build_levels(executor);
  }

  /// Whether found(i) is true for any box that overlaps `box`; asks until it is, in any order.
  template <class Found>
  bool any(const GrowingBox& box, Found&& found) const {
    const Box asked = frame_(box);
    return any_leaf(asked, 0, [&](std::size_t leaf) {
      const Flags overlaps = leaf_[leaf].overlaps(asked);
      for (std::size_t i = 0; i < leaf_size; ++i) {
        if (overlaps[i] != 0 && found(number_[leaf * leaf_size + i])) return true;
      }
      return false;
    });
  }

  /// Calls visit(i, k, worker) for each two boxes that overlap, once, by all threads; no two calls
  /// with the same `worker` run at once. It returns whether more pairs with this i are wanted.
  /// Their order is the same on any number of threads.
  template <class Visit>
  void for_each_pair(Executor& executor, Visit&& visit) const {
    constexpr std::size_t some_leaves = 64;
    parallel_for_ranges(executor, leaf_.size(), some_leaves,
                        [&](std::size_t begin, std::size_t end, std::size_t worker) {
                          for (std::size_t leaf = begin; leaf < end; ++leaf) {
                            visit_pairs_of(leaf, [&](std::size_t i, std::size_t k) {
                              return visit(number_[i], number_[k], worker);
                            });
                          }
                        });
  }

 private:
  static constexpr std::size_t leaf_size = 8;
  using Flags = std::array<std::int32_t, leaf_size>;

  // Of nothing: it overlaps none.
  struct Box {
    std::array<float, 3> low = {3, 3, 3};
    std::array<float, 3> high = {-2, -2, -2};

    Box& operator+=(const Box& more);
  };
  // 1 or 0, without a branch.
  static std::int32_t is_in_order(float low, float high) {
    return static_cast<std::int32_t>(low <= high);
  }
  static bool overlap(const Box& a, const Box& b) {
    std::int32_t overlaps = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      overlaps &= is_in_order(a.low[axis], b.high[axis]) & is_in_order(b.low[axis], a.high[axis]);
    }
    return overlaps != 0;
  }

  // Of all boxes the same side side by side, for vector units.
  struct Leaf {
    std::array<std::array<float, leaf_size>, 3> low;
    std::array<std::array<float, leaf_size>, 3> high;

    void set(std::size_t i, const Box& box) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis][i] = box.low[axis];
        high[axis][i] = box.high[axis];
      }
    }
    [[nodiscard]] Box operator[](std::size_t i) const {
      return {{low[0][i], low[1][i], low[2][i]}, {high[0][i], high[1][i], high[2][i]}};
    }
    [[nodiscard]] Flags overlaps(const Box& box) const {
      Flags flags;
      for (std::size_t i = 0; i < leaf_size; ++i) {
        flags[i] = is_in_order(low[0][i], box.high[0]) & is_in_order(box.low[0], high[0][i]) &
                   is_in_order(low[1][i], box.high[1]) & is_in_order(box.low[1], high[1][i]) &
                   is_in_order(low[2][i], box.high[2]) & is_in_order(box.low[2], high[2][i]);
      }
      return flags;
    }
  };

  // Boxes as small numbers. Rounding keeps the order of coordinates, so what overlaps still does.
  struct Frame {
    Vec3 low = Vec3::Zero();
    double scale = 1;

    Frame() = default;
    explicit Frame(const BoundingBox& all);
    Box operator()(const GrowingBox& box) const;
  };

  template <class BoxOf>
  static BoundingBox bounding_box_of(std::size_t count, BoxOf&& box_of, Executor& executor) {
    if (count == 0) return {};
    const auto all = parallel_reduce<GrowingBox>(executor, count, small_items,
                                                 [&](std::size_t begin, std::size_t end) {
                                                   GrowingBox part;
                                                   for (std::size_t i = begin; i < end; ++i) {
                                                     part += box_of(i);
                                                   }
                                                   return part;
                                                 });
    return {all.low, all.high};
  }
  void build_levels(Executor& executor);

  // Whether found(leaf) is true for one of those from `first` on that overlap.
  template <class Found>
  bool any_leaf(const Box& asked, std::size_t first, Found&& found) const {
    constexpr std::size_t deepest = 64;
    std::array<std::pair<std::uint32_t, std::uint32_t>, deepest> open;  // level, node
    std::size_t count = 0;
    if (!level_.empty()) open[count++] = {static_cast<std::uint32_t>(level_.size() - 1), 0};
    while (count > 0) {
      const auto [level, node] = open[--count];
      if (((std::size_t{node} + 1) << level) <= first) continue;
      if (!overlap(level_[level][node], asked)) continue;
      if (level == 0) {
        if (found(node)) return true;
        continue;
      }
      const std::uint32_t right = 2 * node + 1;
      if (right < level_[level - 1].size()) open[count++] = {level - 1, right};
      open[count++] = {level - 1, 2 * node};
    }
    return false;
  }

  template <class Visit>
  void visit_pairs_of(std::size_t leaf, Visit&& visit) const {
    std::array<bool, leaf_size> is_done{};
    any_leaf(level_[0][leaf], leaf, [&](std::size_t other) {
      for (std::size_t i = 0; i < leaf_size; ++i) {
        const Box box = leaf_[leaf][i];
        if (is_done[i] || !overlap(box, level_[0][other])) continue;
        const Flags overlaps = leaf_[other].overlaps(box);
        for (std::size_t k = other == leaf ? i + 1 : 0; k < leaf_size && !is_done[i]; ++k) {
          if (overlaps[k] != 0) {
            is_done[i] = !visit(leaf * leaf_size + i, other * leaf_size + k);
          }
        }
      }
      return std::find(is_done.begin(), is_done.end(), false) == is_done.end();
    });
  }

  Frame frame_;
  std::vector<std::uint32_t> number_;
  Buffer<Leaf> leaf_;                    // of eight entries of number_ each
  std::vector<std::vector<Box>> level_;  // around leaves; around pairs of those below
};

}  // namespace geolloyd
