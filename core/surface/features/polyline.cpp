#include "core/surface/features/polyline.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace geolloyd {

Polyline::Polyline(const FineMesh& mesh, std::vector<VertexId> vertices, bool is_closed)
    : mesh_(mesh), vertices_(std::move(vertices)), is_closed_(is_closed), arc_(1, 0) {
  for (std::size_t i = 0; i < edges(); ++i) {
    length_ += norm(position(i + 1) - position(i));
    arc_.push_back(arc_.back() + mesh_.sized_length(vertices_[i], vertices_[(i + 1) % size()]));
  }
}

bool Polyline::is_subresolution_hole(double spacing) const {
  constexpr double least_share = 0.6;  // of a spacing
  spacing /= inverse_sizing(0);
  const double third = length_ / 3;
  if (third < least_share * spacing) return true;
  if (third > 1.5 * spacing) return false;
  const Vec3 a = position(0);
  const Vec3 b = point_at(0, third);
  const Vec3 c = point_at(0, 2 * third);
  return std::min({norm(a - b), norm(b - c), norm(c - a)}) < least_share * spacing;
}

std::vector<std::size_t> Polyline::corners(double spacing) const {
  const auto reach_at = [&](std::size_t i) { return spacing / 2 / inverse_sizing(i); };
  const std::size_t first = is_closed_ ? 0 : 1;
  const std::size_t last = is_closed_ ? size() : size() - 1;
  std::vector<double> turn(size(), 1);  // cosine
  for (std::size_t i = first; i < last; ++i) turn[i] = cosine_of_turn(i, reach_at(i));
  std::vector<std::size_t> found;
  for (std::size_t i = first; i < last; ++i) {
    const double reach = reach_at(i);
    if (is_corner(turn[i], i, reach) && is_sharpest(turn, i, reach)) found.push_back(i);
  }
  return found;
}

FeatureCurve Polyline::curve(std::size_t from, std::size_t to) const {
  FeatureCurve curve;
  for (std::size_t i = from; i <= to; ++i) {
    curve.vertices.push_back(vertices_[i % size()]);
    curve.arc.push_back(
        i == from ? 0 : curve.arc.back() + (arc_[(i - 1) % size() + 1] - arc_[(i - 1) % size()]));
  }
  return curve;
}

// At `way` along the path from vertex i, or at its end; negative: backward.
Vec3 Polyline::point_at(std::size_t i, double way) const {
  const std::size_t step = way > 0 ? 1 : size() - 1;
  if (!(length_ > 0)) return position(i);
  double left = std::abs(way);
  if (left >= length_) left = std::fmod(left, length_);  // which is exact
  while (goes_on(i, way > 0)) {
    const std::size_t next = (i + step) % size();
    const double edge = norm(position(next) - position(i));
    if (left < edge) return position(i) + (position(next) - position(i)) * (left / edge);
    left -= edge;
    i = next;
  }
  return position(i);
}

double Polyline::cosine_of_turn(std::size_t i, double reach) const {
  const Vec3 in = normalized(position(i) - point_at(i, -reach));
  const Vec3 out = normalized(point_at(i, reach) - position(i));
  return dot(in, out);
}

// Where the sides are not straight, a smaller turn may be that of a smooth curve, or of a jag.
bool Polyline::is_corner(double cosine, std::size_t i, double reach) const {
  constexpr double sharp_cosine = 0.6427876096865394;  // of 50 degrees
  constexpr double blunt_cosine = 0.8660254037844386;  // of 30 degrees
  if (cosine >= blunt_cosine) return false;
  if (cosine < sharp_cosine) return true;
  constexpr double straight = 0.995;
  return norm(point_at(i, reach) - position(i)) > straight * reach &&
         norm(point_at(i, -reach) - position(i)) > straight * reach;
}

// Of equals, the first one.
bool Polyline::is_sharpest(const std::vector<double>& turn, std::size_t i, double reach) const {
  for (const std::size_t step : {std::size_t{1}, size() - 1}) {
    double way = 0;
    for (std::size_t j = i; way <= reach && goes_on(j, step == 1);) {
      const std::size_t next = (j + step) % size();
      way += norm(position(next) - position(j));
      j = next;
      if (j == i || way > reach) break;
      if (std::pair(turn[j], j) < std::pair(turn[i], i)) return false;
    }
  }
  return true;
}

}  // namespace geolloyd
