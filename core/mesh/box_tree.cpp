#include "core/mesh/box_tree.h"

#include <algorithm>
#include <utility>

namespace geolloyd {

BoxTree::Frame::Frame(const BoundingBox& all) : low(all.low) {
  const double extent = all.extent().maxCoeff();
  if (extent > 0) scale = 1 / extent;
}

// What is far outside is nearer, and still outside.
BoxTree::Box BoxTree::Frame::operator()(const GrowingBox& box) const {
  const auto place = [&](double x, Eigen::Index axis) {
    return static_cast<float>(std::clamp((x - low[axis]) * scale, -1.0, 2.0));
  };
  Box placed;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    placed.low[i] = place(box.low[axis], axis);
    placed.high[i] = place(box.high[axis], axis);
  }
  return placed;
}

BoxTree::Box& BoxTree::Box::operator+=(const Box& more) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis] = std::min(low[axis], more.low[axis]);
    high[axis] = std::max(high[axis], more.high[axis]);
  }
  return *this;
}

void BoxTree::build_levels(Executor& executor) {
  const auto add_level = [&](std::size_t size, auto&& box_of_node) {
    std::vector<Box> level(size);
    parallel_for(executor, size, small_items, [&](std::size_t i) { level[i] = box_of_node(i); });
    level_.push_back(std::move(level));
  };
  if (leaf_.size() == 0) return;
  add_level(leaf_.size(), [&](std::size_t i) {
    Box all;
    for (std::size_t k = 0; k < leaf_size; ++k) all += leaf_[i][k];
    return all;
  });
  while (level_.back().size() > 1) {
    const std::vector<Box>& below = level_.back();
    add_level((below.size() + 1) / 2, [&](std::size_t i) {
      Box all = below[2 * i];
      if (2 * i + 1 < below.size()) all += below[2 * i + 1];
      return all;
    });
  }
}

}  // namespace geolloyd
