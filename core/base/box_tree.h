#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/bounding_box.h"

namespace geolloyd {

inline bool overlap(const GrowingBox& a, const GrowingBox& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

/// Finds which of many boxes overlap another one.
class BoxTree {
 public:
  explicit BoxTree(std::span<const GrowingBox> boxes);

  /// Whether found(i) is true for any box that overlaps `box`; asks until it is, in any order.
  template <class Found>
  bool any(const GrowingBox& box, Found&& found) const {
    constexpr std::size_t deepest = 64;
    std::array<std::uint32_t, deepest> open{};
    std::size_t count = nodes_.empty() ? 0 : 1;
    while (count > 0) {
      const std::uint32_t n = open[--count];
      const Node& node = nodes_[n];
      if (!overlap(node.box, box)) continue;
      if (node.right != 0) {
        open[count++] = node.right;
        open[count++] = n + 1;
        continue;
      }
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        if (overlap(boxes_[i], box) && found(number_[i])) return true;
      }
    }
    return false;
  }

 private:
  struct Node {
    GrowingBox box{};
    std::uint32_t begin = 0;  // of a leaf: into number_
    std::uint32_t end = 0;
    std::uint32_t right = 0;  // the left one follows; 0: a leaf
  };

  void divide(std::span<const GrowingBox> boxes, std::uint32_t begin, std::uint32_t end);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> number_;
  std::vector<GrowingBox> boxes_;  // per entry of number_
};

}  // namespace geolloyd
