#include "core/surface/fit/sample_projection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/loops.h"
#include "core/mesh/closest_on_triangle.h"

namespace geolloyd {

FitError SampleProjection::project() {
  triangle_.resize(samples_.size(), no_id);
  square_distance_.resize(samples_.size());
  parallel_for(executor_, samples_.size(), 256, [&](std::size_t i) {
    const Foot foot = foot_of(i);
    triangle_[i] = foot.triangle;
    square_distance_[i] = dot(foot.away, foot.away);
  });
  FitError error;
  double weights = 0;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    if (triangle_[i] == no_id) continue;
    const double weight = samples_[i].weight;
    weights += weight;
    error.mean_square += weight * square_distance_[i];
    error.largest = std::max(error.largest, square_distance_[i]);
  }
  if (weights > 0) error.mean_square /= weights;
  error.largest = std::sqrt(error.largest);
  return error;
}

// From the triangle of the last time, or those at the vertex the place belongs to, by corners to
// others, until the foot is well inside one.
Foot SampleProjection::foot_of(std::size_t i) const {
  constexpr int most_steps = 8;
  constexpr double far_from_corner = 0.02;  // and, of two corners, from the edge between them
  const Sample sample = samples_[i];
  Foot best;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](TriangleId t) {
    if (t == best.triangle) return false;
    const Foot foot = foot_on(t, sample.point);
    const double square = dot(foot.away, foot.away);
    if (!(square < least)) return false;
    least = square;
    best = foot;
    return true;
  };
  const auto look_around = [&](VertexId v) {
    bool is_nearer = false;
    for (const TriangleId t : remesh_.triangles_at[v]) is_nearer = offer(t) || is_nearer;
    return is_nearer;
  };
  if (triangle_[i] == no_id) {
    look_around(sample.near);
  } else {
    offer(triangle_[i]);
  }
  for (int step = 0; step < most_steps && best.triangle != no_id; ++step) {
    const Foot from = best;
    if (*std::min_element(from.barycentric.begin(), from.barycentric.end()) > far_from_corner)
      break;
    bool is_nearer = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId v = remesh_.triangles[from.triangle][k];
      if (from.barycentric[k] > far_from_corner) is_nearer = look_around(v) || is_nearer;
    }
    if (!is_nearer) break;
  }
  return best;
}

std::vector<double> SampleProjection::largest_at_vertices() const {
  std::vector<double> largest(remesh_.vertex_count(), 0);
  for (std::size_t i = 0; i < triangle_.size(); ++i) {
    if (triangle_[i] == no_id) continue;
    for (const VertexId v : remesh_.triangles[triangle_[i]]) {
      largest[v] = std::max(largest[v], distance(i));
    }
  }
  return largest;
}

Foot SampleProjection::foot_on(TriangleId t, const Vec3& point) const {
  const auto& [ia, ib, ic] = remesh_.triangles[t];
  const Vec3& a = remesh_.positions[ia];
  const Vec3& b = remesh_.positions[ib];
  const Vec3& c = remesh_.positions[ic];
  const std::array<Vec3, 3> p = {a - point, b - point, c - point};
  const Vec3 normal = cross(p[1] - p[0], p[2] - p[0]);
  double u = dot(cross(p[1], p[2]), normal);
  double v = dot(cross(p[2], p[0]), normal);
  double w = dot(cross(p[0], p[1]), normal);
  constexpr double inside = 1e-3;  // of the shares: then the foot of the perpendicular is it
  const double sum = u + v + w;
  if (std::min({u, v, w}) > inside * sum) {
    v /= sum;
    w /= sum;
  } else {
    const auto closest = barycentric_closest_to_origin(p);
    v = closest[0];
    w = closest[1];
  }
  u = 1 - v - w;
  return {t, {u, v, w}, -(u * p[0] + v * p[1] + w * p[2])};
}

}  // namespace geolloyd
