#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bench/zoo/polygon.h"

namespace geolloyd::zoo {
namespace {

// Above 0 where c is left of the way from a to b. Rounding counts as a straight line.
double turn_of(Point a, Point b, Point c) {
  const Point p = {b.x - a.x, b.y - a.y};
  const Point q = {c.x - a.x, c.y - a.y};
  const double turn = p.x * q.y - p.y * q.x;
  const double sizes = (p.x * p.x + p.y * p.y) * (q.x * q.x + q.y * q.y);
  return turn * turn <= 1e-24 * sizes ? 0 : turn;
}

bool is_between(Point a, Point b, Point p) {
  return turn_of(a, b, p) == 0 && (p.x - a.x) * (p.x - b.x) + (p.y - a.y) * (p.y - b.y) < 0;
}

bool segments_cross(Point a, Point b, Point c, Point d) {
  return turn_of(a, b, c) * turn_of(a, b, d) < 0 && turn_of(c, d, a) * turn_of(c, d, b) < 0;
}

// Polygons become one by bridges, there and back, from each inner one to the nearest corner that
// it sees. From the right to the left, so that there always is one.
class Bridges {
 public:
  explicit Bridges(const std::vector<Polygon>& polygons) {
    std::vector<std::vector<std::uint32_t>> holes;
    for (const Polygon& polygon : polygons) {
      std::vector<std::uint32_t> loop(polygon.size());
      for (std::size_t i = 0; i < loop.size(); ++i) {
        loop[i] = static_cast<std::uint32_t>(points_.size() + i);
      }
      points_.insert(points_.end(), polygon.begin(), polygon.end());
      if (&polygon == polygons.data()) {
        loop_ = std::move(loop);
      } else {
        std::reverse(loop.begin(), loop.end());
        begin_at_the_right(loop);
        holes.push_back(std::move(loop));
      }
    }
    std::sort(holes.begin(), holes.end(),
              [&](const auto& a, const auto& b) { return points_[a[0]].x > points_[b[0]].x; });
    for (const auto& hole : holes) add_edges(hole);
    add_edges(loop_);
    for (const auto& hole : holes) join(hole);
  }

  [[nodiscard]] const Polygon& points() const { return points_; }
  [[nodiscard]] const std::vector<std::uint32_t>& loop() const { return loop_; }

 private:
  void begin_at_the_right(std::vector<std::uint32_t>& loop) const {
    std::rotate(loop.begin(),
                std::max_element(loop.begin(), loop.end(),
                                 [&](auto a, auto b) { return points_[a].x < points_[b].x; }),
                loop.end());
  }

  void add_edges(const std::vector<std::uint32_t>& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      edges_.push_back({loop[i], loop[(i + 1) % loop.size()]});
    }
  }

  // Whether the loop has its inside in that direction at its i-th corner.
  [[nodiscard]] bool looks_at(std::size_t i, Point p) const {
    const Point here = points_[loop_[i]];
    const Point before = points_[loop_[(i + loop_.size() - 1) % loop_.size()]];
    const Point after = points_[loop_[(i + 1) % loop_.size()]];
    const bool left_of_next = turn_of(here, after, p) > 0;
    const bool left_of_last = turn_of(before, here, p) > 0;
    const bool is_convex = turn_of(before, here, after) > 0;
    return is_convex ? left_of_next && left_of_last : left_of_next || left_of_last;
  }

  [[nodiscard]] bool is_free(std::uint32_t from, std::uint32_t to) const {
    const Point a = points_[from];
    const Point b = points_[to];
    return std::none_of(edges_.begin(), edges_.end(), [&](const auto& edge) {
      return is_between(a, b, points_[edge[0]]) ||
             segments_cross(a, b, points_[edge[0]], points_[edge[1]]);
    });
  }

  void join(const std::vector<std::uint32_t>& hole) {
    const Point from = points_[hole[0]];
    const auto distance = [&](std::size_t i) {
      return std::hypot(points_[loop_[i]].x - from.x, points_[loop_[i]].y - from.y);
    };
    std::vector<std::size_t> order(loop_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    const auto found = std::find_if(order.begin(), order.end(), [&](std::size_t i) {
      return looks_at(i, from) && is_free(hole[0], loop_[i]);
    });
    if (found == order.end()) throw std::logic_error("a hole sees nothing");
    edges_.push_back({hole[0], loop_[*found]});
    std::vector<std::uint32_t> way(hole.begin(), hole.end());
    way.push_back(hole[0]);
    way.push_back(loop_[*found]);
    loop_.insert(loop_.begin() + static_cast<std::ptrdiff_t>(*found) + 1, way.begin(), way.end());
  }

  Polygon points_;
  std::vector<std::array<std::uint32_t, 2>> edges_;
  std::vector<std::uint32_t> loop_;
};

class Ears {
 public:
  Ears(const Polygon& points, std::vector<std::uint32_t> loop)
      : points_(points), loop_(std::move(loop)) {}

  std::vector<std::array<std::uint32_t, 3>> run() {
    std::size_t at = 0;
    std::size_t tried = 0;
    while (loop_.size() > 3) {
      at %= loop_.size();
      if (is_ear(at)) {
        cut(at);
        tried = 0;
      } else {
        ++at;
        if (++tried > loop_.size()) throw std::logic_error("a polygon has no ear");
      }
    }
    triangles_.push_back({loop_[0], loop_[1], loop_[2]});
    return std::move(triangles_);
  }

 private:
  [[nodiscard]] std::array<std::uint32_t, 3> corner(std::size_t at) const {
    const std::size_t size = loop_.size();
    return {loop_[(at + size - 1) % size], loop_[at], loop_[(at + 1) % size]};
  }

  [[nodiscard]] bool is_ear(std::size_t at) const {
    const auto t = corner(at);
    const Point a = points_[t[0]];
    const Point b = points_[t[1]];
    const Point c = points_[t[2]];
    if (turn_of(a, b, c) <= 0) return false;
    return std::none_of(loop_.begin(), loop_.end(), [&](std::uint32_t v) {
      if (v == t[0] || v == t[1] || v == t[2]) return false;
      const Point p = points_[v];
      return turn_of(a, b, p) >= 0 && turn_of(b, c, p) >= 0 && turn_of(c, a, p) >= 0;
    });
  }

  void cut(std::size_t at) {
    triangles_.push_back(corner(at));
    loop_.erase(loop_.begin() + static_cast<std::ptrdiff_t>(at));
  }

  const Polygon& points_;
  std::vector<std::uint32_t> loop_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulated(const std::vector<Polygon>& polygons) {
  const Bridges bridges(polygons);
  return Ears(bridges.points(), bridges.loop()).run();
}

}  // namespace geolloyd::zoo
