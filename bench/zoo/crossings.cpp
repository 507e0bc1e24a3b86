#include "bench/zoo/crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/vec3.h"

namespace geolloyd::zoo {
namespace {

using Corners = std::array<Vec3, 3>;

// Six times the volume of a tetrahedron; 0 where it is only rounding.
double side_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const Vec3 normal = cross(b - a, c - a);
  const double volume = dot(normal, p - a);
  return std::abs(volume) <= 1e-10 * norm(normal) * (norm(p - a) + norm(b - a)) ? 0 : volume;
}

bool goes_through(const Vec3& from, const Vec3& to, const Corners& t) {
  if (side_of(t[0], t[1], t[2], from) * side_of(t[0], t[1], t[2], to) >= 0) return false;
  const double first = side_of(from, to, t[0], t[1]);
  const double second = side_of(from, to, t[1], t[2]);
  const double third = side_of(from, to, t[2], t[0]);
  return (first > 0 && second > 0 && third > 0) || (first < 0 && second < 0 && third < 0);
}

struct Box {
  Vec3 low;
  Vec3 high;
  TriangleId triangle = 0;
};

class Crossings {
 public:
  explicit Crossings(const Mesh& mesh) : mesh_(mesh) {
    for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
      const auto [a, b, c] = corners(t);
      boxes_.push_back({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c), t});
    }
    std::sort(boxes_.begin(), boxes_.end(),
              [](const Box& a, const Box& b) { return a.low.x() < b.low.x(); });
  }

  [[nodiscard]] std::size_t count() const {
    std::size_t found = 0;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      for (std::size_t j = i + 1; j < boxes_.size(); ++j) {
        if (boxes_[j].low.x() > boxes_[i].high.x()) break;
        found += overlap(boxes_[i], boxes_[j]) && cross_each_other(boxes_[i], boxes_[j]) ? 1 : 0;
      }
    }
    return found;
  }

 private:
  [[nodiscard]] Corners corners(TriangleId t) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    return {mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]};
  }

  static bool overlap(const Box& a, const Box& b) {
    return a.low.y() <= b.high.y() && b.low.y() <= a.high.y() && a.low.z() <= b.high.z() &&
           b.low.z() <= a.high.z();
  }

  [[nodiscard]] bool cross_each_other(const Box& one, const Box& other) const {
    const Triangle& s = mesh_.triangles[one.triangle];
    const Triangle& t = mesh_.triangles[other.triangle];
    if (std::find_first_of(s.begin(), s.end(), t.begin(), t.end()) != s.end()) return false;
    const Corners a = corners(one.triangle);
    const Corners b = corners(other.triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      if (goes_through(a[k], a[(k + 1) % 3], b) || goes_through(b[k], b[(k + 1) % 3], a)) {
        return true;
      }
    }
    return false;
  }

  const Mesh& mesh_;
  std::vector<Box> boxes_;  // by their lower x
};

}  // namespace

std::size_t count_crossings(const Mesh& mesh) {
  return Crossings(mesh).count();
}

}  // namespace geolloyd::zoo
