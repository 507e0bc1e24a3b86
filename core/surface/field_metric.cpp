#include "core/surface/field_metric.h"

#include <cmath>
#include <cstddef>
#include <sstream>

#include "core/base/vec3.h"
#include "core/mesh/metric_mean.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

constexpr double most_stretch = 100 * (1 + 1e-9);  // but for rounding

bool has_stretch(const TangentSpace& space) {
  const double k1 = space.tangent_magnitude;
  const double k2 = space.bitangent_magnitude;
  return k1 > 0 && k2 > 0 && k1 <= most_stretch * k2 && k2 <= most_stretch * k1;
}

void check_stretch(const TangentSpace& space, std::size_t v) {
  if (has_stretch(space)) return;
  std::ostringstream message;
  message << "field: vertex " << v << " has the principal magnitudes " << space.tangent_magnitude
          << " and " << space.bitangent_magnitude
          << ": for a remesh both are above 0, and one at most 100 times the other";
  throw InvalidInput(message.str());
}

Metric shape_of(const TangentSpace& space) {
  if (!has_plane(space)) return {};
  const TangentSpace principal = metric_mean({&space, 1});
  const double stretch = principal.tangent_magnitude / principal.bitangent_magnitude;
  return stretch * Metric::square_of(principal.tangent) +
         1 / stretch * Metric::square_of(principal.bitangent) +
         Metric::square_of(cross(principal.tangent, principal.bitangent));
}

}  // namespace

std::vector<Metric> shapes_of(std::span<const TangentSpace> field) {
  std::vector<Metric> shapes;
  shapes.reserve(field.size());
  for (std::size_t v = 0; v < field.size(); ++v) {
    check_stretch(field[v], v);
    if (has_plane(field[v])) check_stretch(metric_mean({&field[v], 1}), v);
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
      mean += place.weights[c] * shape[mesh.triangles[place.triangle][c]];
    }
    shapes.push_back(mean);
  }
  return shapes;
}

}  // namespace geolloyd
