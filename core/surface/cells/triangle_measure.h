#pragma once

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

}  // namespace geolloyd
