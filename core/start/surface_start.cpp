#include "core/start/surface_start.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/buffer.h"
#include "core/mesh/mesh_measure.h"
#include "core/surface/sizing/field_metric.h"
#include "core/surface/sizing/recipe.h"

namespace geolloyd {
namespace {

// By which sites are spread; empty: evenly.
struct Spread {
  std::vector<Metric> shape;
  std::vector<double> sizes;
};

// With sizes of (k1 k2)^(-1/4), mass times shape (fine_mesh.h) is the metric itself: sites have the
// energy that seeds of a graph have, of squares of distances in the metric by areas in space.
Spread spread_by(std::span<const TangentSpace> field, const Mesh& mesh,
                 std::span<const TriangleId> duplicates, Executor& executor) {
  if (field.empty()) return {};
  Spread spread{shapes_of(field), lengths_of(field)};
  for (double& size : spread.sizes) size = std::sqrt(size);
  const Buffer<double> area = triangle_areas(mesh, duplicates, executor);
  double whole = 0;
  double sized = 0;
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const double inverse = (1 / spread.sizes[a] + 1 / spread.sizes[b] + 1 / spread.sizes[c]) / 3;
    whole += area[t];
    sized += area[t] * (inverse * inverse);
  }
  const double mean = std::sqrt(whole / sized);
  for (double& size : spread.sizes) size /= mean;
  return spread;
}

}  // namespace

bool can_spread(std::span<const TangentSpace> field) {
  constexpr double widest = 1e6;  // the square of how sizes may differ
  if (field.empty()) return true;
  if (!can_shape(field)) return false;
  const std::vector<double> lengths = lengths_of(field);
  const auto [least, most] = std::minmax_element(lengths.begin(), lengths.end());
  return *most <= widest * *least;
}

SurfaceInputOptions surface_options(const Mesh& mesh, std::span<const TriangleId> duplicates,
                                    double area, std::size_t sites) {
  SurfaceInputOptions options;
  options.duplicates = duplicates;
  options.longest_edge = longest_edge(area, sites);
  options.vertex_limit = vertex_limit(mesh, sites);
  return options;
}

SurfaceStart make_surface_start(const Mesh& mesh, std::span<const TriangleId> duplicates,
                                double area, std::size_t sites, std::span<const TangentSpace> field,
                                const RestEffort& effort, Runtime& runtime) {
  Executor& executor = runtime.executor();
  const Spread spread = spread_by(field, mesh, duplicates, executor);
  SurfaceInputOptions input_options = surface_options(mesh, duplicates, area, sites);
  input_options.sizes = spread.sizes;
  input_options.metric = spread.shape;
  SurfaceStart start;
  start.whole =
      std::make_unique<const SurfaceInput>(make_surface_input(mesh, input_options, executor));
  const double spacing =
      spacing_of(start.input().fine.whole_sized_area, static_cast<double>(sites));
  start.divided = std::make_unique<const DividedSurface>(start.input(), spacing, true, executor);
  const RemeshOptions options;
  SiteRelaxer relaxer(start.input(), options, runtime);
  start.resting = rest_sites(start.surface(), sites, relaxer, effort, executor);
  return start;
}

}  // namespace geolloyd
