#include "core/surface/sizing/field_metric.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>

#include "core/base/vec3.h"
#include "core/fields/metric_mean.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

// What cells can follow. Curvature fields have less (core/fields/curvature_field.h).
constexpr double widest_stretch = 100 * (1 + 1e-9);  // but for rounding

bool has_stretch(const TangentSpace& space) {
  const double k1 = space.tangent_magnitude;
  const double k2 = space.bitangent_magnitude;
  return k1 > 0 && k2 > 0 && k1 <= widest_stretch * k2 && k2 <= widest_stretch * k1;
}

// With its principal directions, where there is a plane for them.
TangentSpace principal(const TangentSpace& space) {
  return has_plane(space) ? metric_mean({&space, 1}) : space;
}

bool can_shape(const TangentSpace& space) {
  return has_stretch(space) && has_stretch(principal(space));
}

void check_shape(const TangentSpace& space, std::size_t v) {
  if (can_shape(space)) return;
  const TangentSpace found = has_stretch(space) ? principal(space) : space;
  std::ostringstream message;
  message << "field: vertex " << v << " has the principal magnitudes " << found.tangent_magnitude
          << " and " << found.bitangent_magnitude
          << ": for a remesh both are above 0, and one at most 100 times the other";
  throw InvalidInput(message.str());
}

Metric shape_of(const TangentSpace& space) {
  if (!has_plane(space)) return {};
  const auto [t, b, k1, k2] = principal(space);
  return k1 / k2 * Metric::square_of(t) + k2 / k1 * Metric::square_of(b) +
         Metric::square_of(cross(t, b));
}

}  // namespace

bool can_shape(std::span<const TangentSpace> field) {
  return std::all_of(field.begin(), field.end(),
                     [](const TangentSpace& space) { return can_shape(space); });
}

std::vector<Metric> shapes_of(std::span<const TangentSpace> field) {
  std::vector<Metric> shapes;
  shapes.reserve(field.size());
  for (std::size_t v = 0; v < field.size(); ++v) {
    check_shape(field[v], v);
    shapes.push_back(shape_of(field[v]));
  }
  return shapes;
}

std::vector<double> lengths_of(std::span<const TangentSpace> field) {
  std::vector<double> lengths;
  lengths.reserve(field.size());
  for (const TangentSpace& space : field) {
    lengths.push_back(1 / std::sqrt(space.tangent_magnitude * space.bitangent_magnitude));
  }
  return lengths;
}

std::vector<Metric> shapes_at(const Mesh& mesh, std::span<const Metric> shape,
                              std::span<const SurfacePoint> places) {
  std::vector<Metric> shapes;
  if (shape.empty()) return shapes;
  shapes.reserve(places.size());
  for (const SurfacePoint& place : places) {
    Metric mean = Metric::zero();
    for (std::size_t c = 0; c < 3; ++c) {
      mean += place.barycentric[c] * shape[mesh.triangles[place.triangle][c]];
    }
    shapes.push_back(mean);
  }
  return shapes;
}

}  // namespace geolloyd
