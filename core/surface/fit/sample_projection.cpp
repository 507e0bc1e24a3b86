#include "core/surface/fit/sample_projection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/loops.h"
#include "core/mesh/closest_on_triangle.h"

namespace geolloyd {

FitError SampleProjection::project() {
  triangle_.resize(samples_.size());
  square_distance_.resize(samples_.size());
  parallel_for(executor_, samples_.size(), 256, [&](std::size_t i) {
    const Foot foot = foot_of(samples_[i]);
    triangle_[i] = foot.triangle;
    square_distance_[i] = dot(foot.away, foot.away);
  });
  FitError error;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    if (triangle_[i] == no_id) continue;
    error.sum_of_squares += samples_[i].weight * square_distance_[i];
    error.largest = std::max(error.largest, square_distance_[i]);
  }
  error.largest = std::sqrt(error.largest);
  return error;
}

Foot SampleProjection::foot_of(const Sample& sample) const {
  constexpr int most_steps = 8;
  constexpr double far_from_corner = 0.05;  // and, of two corners, from the edge between them
  Foot best;
  double least = std::numeric_limits<double>::infinity();
  const auto look_around = [&](VertexId v) {
    bool is_nearer = false;
    for (const TriangleId t : remesh_.triangles_at[v]) {
      if (t == best.triangle) continue;
      const Foot foot = foot_on(t, sample.point);
      if (dot(foot.away, foot.away) >= least) continue;
      least = dot(foot.away, foot.away);
      best = foot;
      is_nearer = true;
    }
    return is_nearer;
  };
  look_around(sample.near);
  for (int step = 0; step < most_steps && best.triangle != no_id; ++step) {
    const Foot from = best;
    if (*std::min_element(from.barycentric.begin(), from.barycentric.end()) > far_from_corner)
      break;
    bool is_nearer = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId v = remesh_.triangles[from.triangle][k];
      if (from.barycentric[k] <= far_from_corner || (step == 0 && v == sample.near)) continue;
      is_nearer = look_around(v) || is_nearer;
    }
    if (!is_nearer) break;
  }
  return best;
}

Foot SampleProjection::foot_on(TriangleId t, const Vec3& point) const {
  const auto& [ia, ib, ic] = remesh_.triangles[t];
  const Vec3& a = remesh_.positions[ia];
  const Vec3& b = remesh_.positions[ib];
  const Vec3& c = remesh_.positions[ic];
  const auto [v, w] = barycentric_closest_to_origin({a - point, b - point, c - point});
  const double u = 1 - v - w;
  return {t, {u, v, w}, point - (u * a + v * b + w * c)};
}

}  // namespace geolloyd
