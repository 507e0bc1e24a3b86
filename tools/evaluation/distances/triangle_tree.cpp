#include "tools/evaluation/distances/triangle_tree.h"

#include <cmath>
#include <limits>

#include "core/base/loops.h"
#include "core/mesh/closest_on_triangle.h"
#include "core/mesh/spatial_order.h"

namespace geolloyd {
namespace {

// Less than any distance that counts, and no square of it is 0.
constexpr double hardly_apart = 1e-100;

TriangleCorners seen_from(const Vec3& p, const TriangleCorners& triangle) {
  return {triangle[0] - p, triangle[1] - p, triangle[2] - p};
}

Vec3 closest_to_origin(const TriangleCorners& corner) {
  const auto [v, w] = barycentric_closest_to_origin(corner);
  return corner[0] + v * (corner[1] - corner[0]) + w * (corner[2] - corner[0]);
}

bool has_corner_at(const TriangleCorners& triangle, const Vec3& p) {
  return triangle[0] == p || triangle[1] == p || triangle[2] == p;
}

double square_between(const Vec3& p, const TriangleCorners& triangle) {
  if (has_corner_at(triangle, p)) return 0;
  const Vec3 away = closest_to_origin(seen_from(p, triangle));
  return std::max(dot(away, away), hardly_apart);
}

// Of the triangle: no point of it is nearer than the plane across the way to its closest point that
// has all corners behind it. A foot that is off by rounding makes this less, never more.
double least_between(const Vec3& p, const TriangleCorners& triangle) {
  const TriangleCorners corner = seen_from(p, triangle);
  const Vec3 way = normalized(closest_to_origin(corner));
  return std::min({dot(way, corner[0]), dot(way, corner[1]), dot(way, corner[2])});
}

}  // namespace

TriangleTree::TriangleTree(const Mesh& mesh, const ExactFrame& frame, Executor& executor)
    : triangles_(mesh.triangle_count()) {
  const auto middle_of = [&](std::size_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    return Vec3((frame(mesh.positions[a]) + frame(mesh.positions[b]) + frame(mesh.positions[c])) /
                3);
  };
  const std::vector<std::uint32_t> order =
      spatial_order(mesh.triangle_count(), middle_of, executor);
  parallel_for(executor, order.size(), small_items, [&](std::size_t t) {
    for (std::size_t c = 0; c < 3; ++c) {
      triangles_[t][c] = frame(mesh.positions[mesh.triangles[order[t]][c]]);
    }
  });
  add_boxes(executor);
}

void TriangleTree::add_boxes(Executor& executor) {
  const auto add_level = [&](std::size_t count, auto&& add) {
    std::vector<GrowingBox> level((count + few - 1) / few);
    parallel_for(executor, level.size(), small_items, [&](std::size_t i) {
      const std::size_t end = std::min(count, few * (i + 1));
      for (std::size_t k = few * i; k < end; ++k) add(level[i], k);
    });
    boxes_.push_back(std::move(level));
  };
  add_level(triangles_.size(), [&](GrowingBox& box, std::size_t t) {
    for (const Vec3& p : triangles_[t]) box.add(p);
  });
  while (boxes_.back().size() > 1) {
    const std::vector<GrowingBox>& below = boxes_.back();
    add_level(below.size(), [&](GrowingBox& box, std::size_t k) { box += below[k]; });
  }
}

double TriangleTree::square_to(const GrowingBox& box, std::span<const Vec3> points) const {
  double most = 0;
  for (const Vec3& p : points) {
    double square = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double away = std::max({box.low[axis] - p[axis], p[axis] - box.high[axis], 0.0});
      square += away * away;
    }
    most = std::max(most, square);
  }
  return most;
}

// The nearest last, so that it comes first.
std::size_t TriangleTree::add_children(const Node& node, std::span<const Vec3> points,
                                       double square, std::array<Node, most_open>& open,
                                       std::size_t count) const {
  const std::vector<GrowingBox>& boxes = boxes_[node.level - 1];
  const std::size_t begin = few * std::size_t{node.number};
  const std::size_t end = std::min(boxes.size(), begin + few);
  const std::size_t first = count;
  for (std::size_t i = begin; i < end; ++i) {
    const Node child{square_to(boxes[i], points), node.level - 1, static_cast<std::uint32_t>(i)};
    if (child.square >= square) continue;
    std::size_t place = count++;
    for (; place > first && open[place - 1].square < child.square; --place) {
      open[place] = open[place - 1];
    }
    open[place] = child;
  }
  return count;
}

TriangleTree::Found TriangleTree::closest(std::span<const Vec3> points, double enough,
                                          std::uint32_t guess) const {
  Found best{guess, std::numeric_limits<double>::infinity()};
  // A square that no box is nearer than, once one is good enough.
  const auto visit = [&](std::uint32_t t) {
    double most = 0;
    for (std::size_t i = 0; i < points.size() && most < best.square; ++i) {
      most = std::max(most, square_between(points[i], triangles_[t]));
    }
    if (most < best.square) best = {t, most};
    return best.square <= enough ? 0 : best.square;
  };
  search(points, visit(guess), visit);
  return best;
}

double TriangleTree::least_distance(const Vec3& p, double distance) const {
  double least = distance;
  search({&p, 1}, distance * distance, [&](std::uint32_t t) {
    least = std::min(least, least_between(p, triangles_[t]));
    return distance * distance;
  });
  return std::max(least, 0.0);
}

}  // namespace geolloyd
