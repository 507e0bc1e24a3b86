#include "core/base/box_tree.h"

#include <algorithm>
#include <numeric>

namespace geolloyd {

BoxTree::BoxTree(std::span<const GrowingBox> boxes) : number_(boxes.size()) {
  std::iota(number_.begin(), number_.end(), 0U);
  if (!boxes.empty()) divide(boxes, 0, static_cast<std::uint32_t>(boxes.size()));
  boxes_.reserve(boxes.size());
  for (const std::uint32_t i : number_) boxes_.push_back(boxes[i]);
}

// In halves by the middles of the boxes, across the longest side.
void BoxTree::divide(std::span<const GrowingBox> boxes, std::uint32_t begin, std::uint32_t end) {
  constexpr std::uint32_t few = 4;
  const std::size_t node = nodes_.size();
  nodes_.emplace_back();
  GrowingBox all;
  for (std::uint32_t i = begin; i < end; ++i) all += boxes[number_[i]];
  nodes_[node].box = all;
  if (end - begin <= few) {
    nodes_[node].begin = begin;
    nodes_[node].end = end;
    return;
  }
  int axis = 0;
  (all.high - all.low).maxCoeff(&axis);
  const auto place = [&](std::uint32_t i) { return boxes[i].low[axis] + boxes[i].high[axis]; };
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(number_.begin() + begin, number_.begin() + middle, number_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
  divide(boxes, begin, middle);
  nodes_[node].right = static_cast<std::uint32_t>(nodes_.size());
  divide(boxes, middle, end);
}

}  // namespace geolloyd
