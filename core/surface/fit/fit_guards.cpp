#include "core/surface/fit/fit_guards.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/mesh_quality.h"
#include "core/repair/crossings.h"

namespace geolloyd {
namespace {

// The cosine of an angle that is 2 degrees smaller; that of a small angle.
double turned_by_two_degrees(double cosine) {
  constexpr double cosine_of_eight = 0.9902680687415704;
  constexpr double cosine_of_two = 0.9993908270190958;
  constexpr double sine_of_two = 0.03489949670250097;
  if (cosine >= cosine_of_eight) return cosine;
  return cosine * cosine_of_two + std::sqrt(1 - cosine * cosine) * sine_of_two;
}

}  // namespace

FitGuards::FitGuards(const MovingRemesh& remesh, std::span<const Metric> metric, double side)
    : remesh_(remesh), metric_(metric), highest_(0.6 * side), normal_(normals_at_vertices(remesh)) {
  double largest = -1;
  for (TriangleId t = 0; t < remesh_.triangle_count(); ++t) {
    first_cosine_.push_back(largest_cosine(t));
    largest = std::max(largest, first_cosine_.back());
  }
  most_cosine_ = std::min(turned_by_two_degrees(largest), 1.0);
}

std::vector<std::uint8_t> FitGuards::bad_vertices() const {
  std::vector<std::uint8_t> is_bad_one(remesh_.vertex_count(), 0);
  for (std::size_t v = 0; v < is_bad_one.size(); ++v) {
    if (std::abs(dot(remesh_.move_of(v), normal_[v])) > highest_) is_bad_one[v] = 1;
  }
  for (TriangleId t = 0; t < remesh_.triangle_count(); ++t) {
    if (!is_bad(t)) continue;
    for (const VertexId v : remesh_.triangles[t]) is_bad_one[v] = 1;
  }
  return is_bad_one;
}

void FitGuards::add_narrowed(std::vector<std::uint8_t>& is_bad_one) const {
  constexpr double cosine_of_28 = 0.882947592858927;
  for (TriangleId t = 0; t < remesh_.triangle_count(); ++t) {
    const double cosine = largest_cosine(t);
    if (cosine <= cosine_of_28) continue;
    if (cosine <= turned_by_two_degrees(first_cosine_[t])) continue;
    for (const VertexId v : remesh_.triangles[t]) is_bad_one[v] = 1;
  }
}

void FitGuards::add_crossing(std::vector<std::uint8_t>& is_bad_one, Executor& executor) const {
  const std::vector<TrianglePair> crossings = find_crossings(remesh_, executor);
  if (crossings.empty()) return;
  if (!find_crossings({remesh_.start, remesh_.triangles}, executor).empty()) return;
  mark_corners(remesh_, crossings, is_bad_one);
}

bool FitGuards::is_bad(TriangleId t) const {
  constexpr double least_turn_cosine = 0.25882;  // of 75 degrees
  const auto& [a, b, c] = remesh_.triangles[t];
  const Vec3 old = cross(remesh_.start[b] - remesh_.start[a], remesh_.start[c] - remesh_.start[a]);
  return largest_cosine(t) > most_cosine_ ||
         dot(normalized(old), remesh_.normal_of(t)) < least_turn_cosine;
}

// Of the smallest angle.
double FitGuards::largest_cosine(TriangleId t) const {
  return cosine_of_smallest_angle(corners_of(remesh_, remesh_.triangles[t], metric_));
}

}  // namespace geolloyd
