#include "core/surface/result/fit_guards.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/mesh_quality.h"

namespace geolloyd {
namespace {

// The cosine of an angle that is 2 degrees smaller.
double turned_by_two_degrees(double cosine) {
  constexpr double cosine_of_two = 0.9993908270190958;
  constexpr double sine_of_two = 0.03489949670250097;
  if (cosine >= cosine_of_two) return 1;
  return cosine * cosine_of_two + std::sqrt(1 - cosine * cosine) * sine_of_two;
}

}  // namespace

FitGuards::FitGuards(MovingRemesh& remesh, std::span<const Metric> metric)
    : remesh_(remesh),
      metric_(metric),
      most_cosine_(std::min(turned_by_two_degrees(largest_cosine_of_all()), 1.0)) {}

double FitGuards::mean_quality() const {
  double sum = 0;
  for (const Triangle& t : remesh_.triangles) {
    sum += triangle_quality(corners_of(remesh_, t, metric_));
  }
  return sum / static_cast<double>(remesh_.triangle_count());
}

void FitGuards::undo_bad_moves(const std::vector<Vec3>& before) {
  std::vector<TriangleId> bad;
  do {
    bad.clear();
    for (TriangleId t = 0; t < remesh_.triangle_count(); ++t) {
      if (is_bad(t)) bad.push_back(t);
    }
    std::size_t undone = 0;
    for (const TriangleId t : bad) {
      for (const VertexId v : remesh_.triangles[t]) {
        if (remesh_.positions[v] == before[v]) continue;
        remesh_.positions[v] = before[v];
        ++undone;
      }
    }
    if (undone == 0) return;
  } while (!bad.empty());
}

bool FitGuards::is_bad(TriangleId t) const {
  constexpr double least_turn_cosine = 0.8660254037844386;  // of 30 degrees
  const auto& [a, b, c] = remesh_.triangles[t];
  const Vec3 old = cross(remesh_.start[b] - remesh_.start[a], remesh_.start[c] - remesh_.start[a]);
  return largest_cosine(t) > most_cosine_ ||
         dot(normalized(old), remesh_.normal_of(t)) < least_turn_cosine;
}

// Of the smallest angle.
double FitGuards::largest_cosine(TriangleId t) const {
  return cosine_of_smallest_angle(corners_of(remesh_, remesh_.triangles[t], metric_));
}

double FitGuards::largest_cosine_of_all() const {
  double largest = -1;
  for (TriangleId t = 0; t < remesh_.triangle_count(); ++t) {
    largest = std::max(largest, largest_cosine(t));
  }
  return largest;
}

}  // namespace geolloyd
