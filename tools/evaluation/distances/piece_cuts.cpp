#include "tools/evaluation/distances/piece_cuts.h"

#include <algorithm>
#include <array>
#include <optional>

namespace geolloyd {
namespace {

// Of the corners, how far each is beyond a wall.
using Heights = std::array<double, 3>;

double square_of_edge(const TriangleCorners& corner, std::size_t i) {
  const Vec3 edge = corner[(i + 1) % 3] - corner[i];
  return dot(edge, edge);
}

std::size_t longest_edge(const TriangleCorners& corner) {
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (square_of_edge(corner, i) > square_of_edge(corner, longest)) longest = i;
  }
  return longest;
}

class PieceCut {
 public:
  PieceCut(const SurfacePiece& piece, std::vector<SurfacePiece>& pieces, std::vector<Vec3>& corners)
      : piece_(piece), pieces_(pieces), corners_(corners) {}

  void in_halves() {
    const TriangleCorners& corner = piece_.corner;
    const std::size_t i = longest_edge(corner);
    const Vec3& a = corner[i];
    const Vec3& b = corner[(i + 1) % 3];
    const Vec3& c = corner[(i + 2) % 3];
    const Vec3 middle = (a + b) / 2;
    corners_.push_back(middle);
    add({a, middle, c});
    add({middle, b, c});
  }

  // Some are beyond, some are not, others are on the wall.
  void at(const Heights& height) {
    const std::size_t alone = find_alone(height);
    const std::size_t next = (alone + 1) % 3;
    const std::size_t last = (alone + 2) % 3;
    const Vec3 to_next = crossing(height, alone, next);
    const Vec3 to_last = crossing(height, alone, last);
    add({piece_.corner[alone], to_next, to_last});
    if (height[next] != 0) add({to_next, piece_.corner[next], piece_.corner[last]});
    if (height[last] != 0) add({to_next, piece_.corner[last], to_last});
  }

 private:
  // The corner that has its side of the wall for itself.
  static std::size_t find_alone(const Heights& height) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double next = height[(i + 1) % 3];
      const double last = height[(i + 2) % 3];
      if (height[i] > 0 && next <= 0 && last <= 0) return i;
      if (height[i] < 0 && next >= 0 && last >= 0) return i;
    }
    return 0;
  }

  Vec3 crossing(const Heights& height, std::size_t from, std::size_t to) {
    if (height[to] == 0) return piece_.corner[to];
    const double share = height[from] / (height[from] - height[to]);
    corners_.emplace_back(piece_.corner[from] + share * (piece_.corner[to] - piece_.corner[from]));
    return corners_.back();
  }

  void add(const TriangleCorners& corner) {
    pieces_.push_back({corner, piece_.near, piece_.depth + 1});
  }

  const SurfacePiece& piece_;
  std::vector<SurfacePiece>& pieces_;
  std::vector<Vec3>& corners_;
};

// The wall beyond which a corner is farthest, of those that run through the piece.
std::optional<Heights> find_wall(const TriangleCorners& piece, const TriangleCorners& near,
                                 double slack) {
  const Vec3 normal = normalized(cross(near[1] - near[0], near[2] - near[0]));
  std::optional<Heights> wall;
  double farthest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 outward = normalized(cross(near[(i + 1) % 3] - near[i], normal));
    Heights height{};
    for (std::size_t c = 0; c < 3; ++c) {
      const double beyond = dot(outward, piece[c] - near[i]);
      height[c] = beyond > slack || beyond < -slack ? beyond : 0;
    }
    const auto [least, most] = std::minmax_element(height.begin(), height.end());
    if (!(*least < 0) || *most <= farthest) continue;
    farthest = *most;
    wall = height;
  }
  return wall;
}

}  // namespace

void cut(const SurfacePiece& piece, const TriangleCorners& near, double slack,
         std::vector<SurfacePiece>& pieces, std::vector<Vec3>& corners) {
  constexpr double much_longer = 2;
  PieceCut made(piece, pieces, corners);
  const double square = square_of_edge(piece.corner, longest_edge(piece.corner));
  const double near_square = square_of_edge(near, longest_edge(near));
  std::optional<Heights> wall;
  if (square <= much_longer * much_longer * near_square) {
    wall = find_wall(piece.corner, near, slack);
  }
  wall ? made.at(*wall) : made.in_halves();
}

}  // namespace geolloyd
