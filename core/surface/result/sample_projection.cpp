#include "core/surface/result/sample_projection.h"

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
  Foot best;
  double least = std::numeric_limits<double>::infinity();
  for (const TriangleId t : remesh_.triangles_at[sample.near]) {
    const Foot foot = foot_on(t, sample.point);
    if (dot(foot.away, foot.away) >= least) continue;
    least = dot(foot.away, foot.away);
    best = foot;
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
