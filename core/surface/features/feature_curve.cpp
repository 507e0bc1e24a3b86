#include "core/surface/features/feature_curve.h"

#include <algorithm>

#include "core/base/rounding.h"

namespace geolloyd {

double FeatureCurve::place(std::size_t i, std::size_t intervals) const {
  if (i == 0) return 0;
  if (i >= intervals) return length();
  const double steps = static_cast<double>(intervals) - 2 + first_step + last_step;
  return length() * (first_step + static_cast<double>(i - 1)) / steps;
}

std::size_t FeatureCurve::intervals_in(double length, double spacing) const {
  const std::size_t most = vertices.size() - 1;
  if (!(length < spacing * static_cast<double>(most))) return most;
  return std::clamp(round_to_whole(length / spacing), std::min(least_intervals, most), most);
}

std::size_t FeatureCurve::edge_at(double at) const {
  const auto above = std::upper_bound(arc.begin() + 1, arc.end() - 1, at);
  return static_cast<std::size_t>(above - arc.begin()) - 1;
}

Vec3 FeatureCurve::point_at(const FineMesh& mesh, double at) const {
  const std::size_t edge = edge_at(at);
  const Vec3& a = mesh.positions[vertices[edge]];
  const Vec3& b = mesh.positions[vertices[edge + 1]];
  const double length = arc[edge + 1] - arc[edge];
  return length > 0 ? Vec3(a + (b - a) * ((at - arc[edge]) / length)) : a;
}

double FeatureCurve::sized_length(const FineMesh& mesh, double at, const Vec3& displacement) const {
  const std::size_t edge = edge_at(at);
  const VertexId a = vertices[edge];
  const VertexId b = vertices[edge + 1];
  return mesh.length_between(a, b, displacement) *
         ((mesh.inverse_sizing_at(a) + mesh.inverse_sizing_at(b)) / 2);
}

}  // namespace geolloyd
