#pragma once

#include <cstddef>
#include <span>

#include "core/surface/cells/clipped_polygon.h"

namespace geolloyd {

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
  FewSites candidates;
  candidates.add(main);
  for (const RegionId r : triangle.at) candidates.add(r);
  for (std::size_t i = 0; i < triangle.others.size(); ++i) candidates.add(triangle.others[i]);
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    ClippedPolygon polygon;
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
  emit(b, triangle.measure.round(unit,
                                 ClippedPolygon({{1, 0}, on_bc, middle, on_ab}).moments(triangle)));
  emit(c, triangle.measure.round(unit,
                                 ClippedPolygon({{0, 1}, on_ac, middle, on_bc}).moments(triangle)));
  return true;
}

}  // namespace geolloyd
