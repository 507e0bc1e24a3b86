#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>

#include "core/surface/cells/moments.h"
#include "core/surface/substrate/fine_mesh.h"

namespace geolloyd {

/// How a triangle measures where there is no metric.
class EvenMeasure {
 public:
  using Sum = Moments;

  EvenMeasure(const FineMesh& /*mesh*/, TriangleId /*t*/) {}
  [[nodiscard]] const Vec3& operator()(const Vec3& p) const { return p; }
  [[nodiscard]] Sum round(const MomentUnit& unit, const PieceMoments& piece) const {
    return unit.round(piece);
  }
};

/// The same in a metric, which is constant within a triangle: its root maps the triangle to one
/// that is measured as usual.
class MetricMeasure {
 public:
  using Sum = MetricMoments;

  MetricMeasure(const FineMesh& mesh, TriangleId t) : metric_(mesh.metric_of(t)), root_(metric_) {}
  [[nodiscard]] Vec3 operator()(const Vec3& p) const { return root_(p); }
  [[nodiscard]] Sum round(const MomentUnit& unit, PieceMoments piece) const {
    piece.first = root_.transposed(piece.first);
    return unit.round(piece, metric_);
  }

 private:
  Metric metric_;
  MetricRoot root_;
};

/// Moments of a triangle that lies in one cell.
template <class Measure = EvenMeasure>
typename Measure::Sum moments_of(const FineMesh& mesh, const MomentUnit& unit, TriangleId t) {
  const Measure measure(mesh, t);
  const auto& [a, b, c] = mesh.triangles[t];
  return measure.round(unit,
                       moments_of_triangle(measure(mesh.positions[a]), measure(mesh.positions[b]),
                                           measure(mesh.positions[c]), mesh.mass(t)));
}

/// The site that has of a triangle what other sites do not cut off: that of two corners or more,
/// else that of the first corner with a label, or none.
inline RegionId main_site(const FineMesh& mesh, TriangleId t, std::span<const RegionId> labels) {
  const auto& [a, b, c] = mesh.triangles[t];
  if (labels[b] == labels[c] && labels[b] != no_id) return labels[b];
  if (labels[a] != no_id) return labels[a];
  return labels[b] != no_id ? labels[b] : labels[c];
}

/// Calls emit(site, moments) for each piece that a site other than the main one has in a triangle.
///
/// A triangle whose corners have one label lies wholly in that site's cell, because Euclidean cells
/// are convex. Other triangles are cut by the bisector planes of the candidates: the labels of its
/// corners, and of the vertices beyond its edges. The main site has the rest, so that shares sum to
/// the moments of the triangle exactly.
template <class Measure = EvenMeasure, class Emit>
void for_each_piece(const FineMesh& mesh, const MomentUnit& unit, TriangleId t,
                    std::span<const RegionId> labels, std::span<const Vec3> sites, Emit&& emit);

namespace cell_pieces_detail {

/// A few different sites.
class Sites {
 public:
  void add(RegionId r) {
    if (r == no_id || has(r)) return;
    site_[size_++] = r;
  }
  [[nodiscard]] bool has(RegionId r) const {
    for (std::size_t i = 0; i < size_; ++i) {
      if (site_[i] == r) return true;
    }
    return false;
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] RegionId operator[](std::size_t i) const { return site_[i]; }

 private:
  RegionId site_[6] = {};
  std::size_t size_ = 0;
};

/// A point of a triangle a, b, c: a + u (b - a) + v (c - a).
struct InTriangle {
  double u;
  double v;
};

/// A triangle with the labels of its corners, which are not all the same. Corners and sites are as
/// its measure maps them.
template <class Measure>
struct CutTriangle {
  Measure measure;
  std::span<const Vec3> sites;
  Vec3 corner[3];
  double mass;
  RegionId at[3] = {};
  Sites others;  ///< labels of the vertices beyond its edges that are no corner's

  CutTriangle(const FineMesh& mesh, TriangleId t, std::span<const RegionId> labels,
              std::span<const Vec3> all_sites)
      : measure(mesh, t), sites(all_sites), mass(mesh.mass(t)) {
    const Triangle& corners = mesh.triangles[t];
    for (std::size_t c = 0; c < 3; ++c) {
      corner[c] = measure(mesh.positions[corners[c]]);
      at[c] = labels[corners[c]];
    }
    for (const VertexId v : mesh.across[t]) {
      if (v == no_id) continue;
      const RegionId r = labels[v];
      if (r != at[0] && r != at[1] && r != at[2]) others.add(r);
    }
  }

  [[nodiscard]] decltype(auto) site(RegionId r) const { return measure(sites[r]); }
  [[nodiscard]] Vec3 point(const InTriangle& p) const {
    return corner[0] + p.u * (corner[1] - corner[0]) + p.v * (corner[2] - corner[0]);
  }
  /// Whether no other site is nearer to one of these points than the point's owner.
  template <std::size_t count>
  [[nodiscard]] bool others_own_none(const Vec3 (&point)[count],
                                     const RegionId (&owner)[count]) const {
    for (std::size_t o = 0; o < others.size(); ++o) {
      for (std::size_t i = 0; i < count; ++i) {
        const Vec3 away = point[i] - site(owner[i]);
        const Vec3 other = point[i] - site(others[o]);
        if (!(dot(away, away) <= dot(other, other))) return false;
      }
    }
    return true;
  }
};

/// A convex polygon within a triangle.
class Polygon {
 public:
  /// The whole triangle.
  Polygon() : Polygon({{0, 0}, {1, 0}, {0, 1}}) {}
  /// Counterclockwise.
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): places behind size_ are never read
  Polygon(std::initializer_list<InTriangle> vertices) {
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

/// Of a point: square distance to one site less that to another. Negative where the first is
/// nearer.
class Bisector {
 public:
  Bisector(const Vec3& first, const Vec3& second)
      : first_(first), between_(second - first), square_(dot(between_, between_)) {}
  [[nodiscard]] double operator()(const Vec3& x) const {
    return 2 * dot(x - first_, between_) - square_;
  }

 private:
  Vec3 first_;
  Vec3 between_;
  double square_;
};

/// Any labels and others: each site's piece is what the bisectors with all others leave.
template <class Measure, class Emit>
void cut_in_pieces(const CutTriangle<Measure>& triangle, RegionId main, const MomentUnit& unit,
                   Emit&& emit) {
  Sites candidates;
  candidates.add(main);
  for (const RegionId r : triangle.at) candidates.add(r);
  for (std::size_t i = 0; i < triangle.others.size(); ++i) candidates.add(triangle.others[i]);
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    Polygon polygon;
    for (std::size_t j = 0; j < candidates.size(); ++j) {
      if (i == j) continue;
      const Bisector side(triangle.site(candidates[i]), triangle.site(candidates[j]));
      const double f[3] = {side(triangle.corner[0]), side(triangle.corner[1]),
                           side(triangle.corner[2])};
      polygon.clip(f, candidates[i] < candidates[j]);
    }
    if (!polygon.is_empty())
      emit(candidates[i], triangle.measure.round(unit, polygon.moments(triangle)));
  }
}

/// Two corners are the main site's, and the bisector cuts the third one off. False where it is not
/// so; then nothing is emitted.
template <class Measure, class Emit>
bool cut_corner_off(const CutTriangle<Measure>& triangle, std::size_t odd, const MomentUnit& unit,
                    Emit&& emit) {
  const RegionId own = triangle.at[odd];
  const RegionId main = triangle.at[(odd + 1) % 3];
  if (own == no_id || main == no_id) return false;
  const Vec3& p = triangle.corner[odd];
  const Vec3& q = triangle.corner[(odd + 1) % 3];
  const Vec3& r = triangle.corner[(odd + 2) % 3];
  const Bisector side(triangle.site(own), triangle.site(main));
  const double at_p = side(p);
  const double at_q = side(q);
  const double at_r = side(r);
  if (!(at_p <= 0 && at_q >= 0 && at_r >= 0)) return false;
  const double to_q = at_p < 0 ? at_p / (at_p - at_q) : 0;
  const double to_r = at_p < 0 ? at_p / (at_p - at_r) : 0;
  const Vec3 on_q = p + to_q * (q - p);
  const Vec3 on_r = p + to_r * (r - p);
  if (!triangle.others_own_none({p, on_q, on_r, q, r}, {own, own, own, main, main})) {
    return false;
  }
  emit(own, triangle.measure.round(
                unit, moments_of_triangle(p, on_q, on_r, to_q * to_r * triangle.mass)));
  return true;
}

/// Three sites have a corner each, and meet in a point of the triangle, from which a border runs to
/// each edge. False where it is not so; then nothing is emitted.
template <class Measure, class Emit>
bool cut_about_point(const CutTriangle<Measure>& triangle, const MomentUnit& unit, Emit&& emit) {
  const auto& [a, b, c] = triangle.at;
  if (a == no_id || b == no_id || c == no_id) return false;
  const auto& [at_a, at_b, at_c] = triangle.corner;
  const Bisector ab(triangle.site(a), triangle.site(b));
  const Bisector ac(triangle.site(a), triangle.site(c));
  const double f[3] = {ab(at_a), ab(at_b), ab(at_c)};
  const double g[3] = {ac(at_a), ac(at_b), ac(at_c)};
  const double b_less_c[2] = {g[1] - f[1], g[2] - f[2]};  // at b and c
  if (!(f[0] < 0 && g[0] < 0 && f[1] > 0 && b_less_c[0] < 0 && g[2] > 0 && b_less_c[1] > 0)) {
    return false;
  }
  const double turn = (f[1] - f[0]) * (g[2] - g[0]) - (f[2] - f[0]) * (g[1] - g[0]);
  const InTriangle middle = {(g[0] * (f[2] - f[0]) - f[0] * (g[2] - g[0])) / turn,
                             (f[0] * (g[1] - g[0]) - g[0] * (f[1] - f[0])) / turn};
  if (!(middle.u >= 0 && middle.v >= 0 && middle.u + middle.v <= 1)) return false;
  const double to_b = f[0] / (f[0] - f[1]);
  const double to_c = g[0] / (g[0] - g[2]);
  const double b_to_c = b_less_c[0] / (b_less_c[0] - b_less_c[1]);
  const InTriangle on_ab = {to_b, 0};
  const InTriangle on_ac = {0, to_c};
  const InTriangle on_bc = {1 - b_to_c, b_to_c};
  if (triangle.others.size() > 0 &&
      !triangle.others_own_none({at_a, at_b, at_c, triangle.point(on_ab), triangle.point(on_ac),
                                 triangle.point(on_bc), triangle.point(middle)},
                                {a, b, c, a, a, b, a})) {
    return false;
  }
  emit(b, triangle.measure.round(unit, Polygon({{1, 0}, on_bc, middle, on_ab}).moments(triangle)));
  emit(c, triangle.measure.round(unit, Polygon({{0, 1}, on_ac, middle, on_bc}).moments(triangle)));
  return true;
}

}  // namespace cell_pieces_detail

template <class Measure, class Emit>
void for_each_piece(const FineMesh& mesh, const MomentUnit& unit, TriangleId t,
                    std::span<const RegionId> labels, std::span<const Vec3> sites, Emit&& emit) {
  using namespace cell_pieces_detail;
  const auto& [a, b, c] = mesh.triangles[t];
  if (labels[a] == labels[b] && labels[b] == labels[c]) return;
  const CutTriangle<Measure> triangle(mesh, t, labels, sites);
  const auto& at = triangle.at;
  if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0]) {
    const std::size_t odd = at[1] == at[2] ? 0 : at[0] == at[2] ? 1 : 2;
    if (cut_corner_off(triangle, odd, unit, emit)) return;
  } else if (cut_about_point(triangle, unit, emit)) {
    return;
  }
  cut_in_pieces(triangle, main_site(mesh, t, labels), unit, emit);
}

}  // namespace geolloyd
