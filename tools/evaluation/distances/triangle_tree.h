#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/bounding_box.h"
#include "core/base/executor.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_quality.h"
#include "tools/evaluation/distances/exact_frame.h"

namespace geolloyd {

/// The triangles of a surface in boxes, four in each and four boxes in each larger one, all in
/// double. Triangles have numbers of their own, along a curve through space.
class TriangleTree {
 public:
  /// Coordinates are those of the frame. Of a mesh with at least one triangle.
  TriangleTree(const Mesh& mesh, const ExactFrame& frame, Executor& executor);

  [[nodiscard]] const TriangleCorners& triangle(std::uint32_t number) const {
    return triangles_[number];
  }

  struct Found {
    std::uint32_t triangle = 0;
    double square = 0;  ///< the largest of the points' squared distances to it; 0 only where it has
                        ///< corners at all of them
  };

  /// The triangle that is closest to all `points` at once: so is it to the hull of them, because
  /// the distance to a triangle is convex. The first one found with a square of at most `enough`
  /// will do. `guess` is the first that is tried.
  [[nodiscard]] Found closest(std::span<const Vec3> points, double enough,
                              std::uint32_t guess) const;

  /// No more than the distance from `p` to the surface, however thin triangles are, but for the
  /// rounding of coordinates. `distance` is that to some triangle.
  [[nodiscard]] double least_distance(const Vec3& p, double distance) const;

 private:
  static constexpr std::size_t few = 4;

  struct Node {
    double square;  // of the distance to its box
    std::uint32_t level;
    std::uint32_t number;
  };
  static constexpr std::size_t most_open = 64;  // three of each level, and four

  void add_boxes(Executor& executor);
  [[nodiscard]] double square_to(const GrowingBox& box, std::span<const Vec3> points) const;

  // Calls visit(triangle) for those in boxes that are nearer than the square that it returned last.
  template <class Visit>
  void search(std::span<const Vec3> points, double square, Visit&& visit) const {
    std::array<Node, most_open> open{};
    std::size_t count = 1;
    open[0] = {0, static_cast<std::uint32_t>(boxes_.size() - 1), 0};
    while (count > 0) {
      const Node node = open[--count];
      if (node.square >= square) continue;
      if (node.level > 0) {
        count = add_children(node, points, square, open, count);
        continue;
      }
      const std::size_t end = std::min(triangles_.size(), few * (node.number + std::size_t{1}));
      for (std::size_t t = few * std::size_t{node.number}; t < end; ++t) {
        square = visit(static_cast<std::uint32_t>(t));
      }
    }
  }
  std::size_t add_children(const Node& node, std::span<const Vec3> points, double square,
                           std::array<Node, most_open>& open, std::size_t count) const;

  std::vector<TriangleCorners> triangles_;
  std::vector<std::vector<GrowingBox>> boxes_;  // per level; the last has one
};

}  // namespace geolloyd
