#pragma once

#include <cstddef>
#include <initializer_list>

#include "core/surface/cells/cut_triangle.h"

namespace geolloyd {

/// A convex polygon within a triangle.
class ClippedPolygon {
 public:
  /// The whole triangle.
  ClippedPolygon() : ClippedPolygon({{0, 0}, {1, 0}, {0, 1}}) {}
  /// Counterclockwise.
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): places behind size_ are never read
  ClippedPolygon(std::initializer_list<InTriangle> vertices) {
    for (const InTriangle& vertex : vertices) vertex_[size_++] = vertex;
  }

  /// Keeps the part where a function that is linear, with the values `f` at the triangle's corners,
  /// is negative. Where it is zero all over, all is kept if `keeps_zero`.
  void clip(const double (&f)[3], bool keeps_zero) {
    double at[most];
    std::size_t below = 0;
    std::size_t above = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      at[i] = f[0] + vertex_[i].u * (f[1] - f[0]) + vertex_[i].v * (f[2] - f[0]);
      if (at[i] < 0) ++below;
      if (at[i] > 0) ++above;
    }
    if (above == 0 && (below > 0 || keeps_zero)) return;
    if (below == 0) {
      size_ = 0;
      return;
    }
    InTriangle kept[most];
    std::size_t count = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const std::size_t next = i + 1 < size_ ? i + 1 : 0;
      if (at[i] <= 0) kept[count++] = vertex_[i];
      if ((at[i] < 0 && at[next] > 0) || (at[i] > 0 && at[next] < 0)) {
        const double share = at[i] / (at[i] - at[next]);
        kept[count++] = {vertex_[i].u + share * (vertex_[next].u - vertex_[i].u),
                         vertex_[i].v + share * (vertex_[next].v - vertex_[i].v)};
      }
    }
    for (std::size_t i = 0; i < count; ++i) vertex_[i] = kept[i];
    size_ = count;
  }

  [[nodiscard]] bool is_empty() const { return size_ == 0; }

  template <class Measure>
  [[nodiscard]] PieceMoments moments(const CutTriangle<Measure>& triangle) const {
    PieceMoments sum;
    for (std::size_t i = 2; i < size_; ++i) {
      const InTriangle& p = vertex_[0];
      const InTriangle& q = vertex_[i - 1];
      const InTriangle& r = vertex_[i];
      const double share = (q.u - p.u) * (r.v - p.v) - (q.v - p.v) * (r.u - p.u);
      const PieceMoments more = moments_of_triangle(triangle.point(p), triangle.point(q),
                                                    triangle.point(r), share * triangle.mass);
      sum.area += more.area;
      sum.first += more.first;
      sum.second += more.second;
    }
    return sum;
  }

 private:
  // Rounding may make it a sliver that is not quite convex. Of n vertices n / 2 at most are then
  // cut off, each by two crossings at most, so a clipping adds n / 2: 3, 4, 6, 9, 13, 19.
  static constexpr std::size_t most = 19;

  InTriangle vertex_[most];
  std::size_t size_ = 0;
};

}  // namespace geolloyd
