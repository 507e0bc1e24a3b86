#include "core/surface/flips/gliding_remesh.h"

#include <algorithm>
#include <utility>

#include "core/surface/fit/asked_areas.h"
#include "core/surface/fit/sample_projection.h"

namespace geolloyd {
namespace {

constexpr std::size_t samples_per_vertex = 4;
constexpr double price_of_mean_strain = 0.0065;  // as that of a fit

}  // namespace

GlidingRemesh::GlidingRemesh(const SurfaceInput& input, std::span<const RegionId> labels,
                             std::size_t held, std::span<const std::array<VertexId, 2>> kept_edges,
                             std::span<const std::uint8_t> barred_vertices, const Mesh& remesh,
                             Executor& executor)
    : samples(input.fine, labels, remesh.vertex_count(), samples_per_vertex),
      kept(kept_edges),
      barred(barred_vertices),
      triangles(remesh.vertex_count(), remesh.triangles),
      on_triangle(remesh.triangle_count()),
      price(price_of_mean_strain / static_cast<double>(remesh.triangle_count())) {
  MovingRemesh moving(input.frame, remesh, executor);
  AskedAreas asked = find_asked_areas(moving, !input.fine.inverse_sizing.empty());
  SampleProjection projection(samples, moving, executor);
  const FitError error = projection.project();
  double weight = 0;
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    const TriangleId t = projection.triangles()[i];
    if (t == no_id) continue;
    weight += samples[i].weight;
    on_triangle[t].push_back({i, projection.square_distance(i)});
  }
  fit = {held, held, asked.side, std::move(asked.at_vertex),
         FitSetting::Whole{weight, error.mean_square}};
  largest_square = error.largest * error.largest;
  positions = std::move(moving.positions);
}

bool GlidingRemesh::is_kept(VertexId a, VertexId b) const {
  return a < fit.held && b < fit.held &&
         std::binary_search(kept.begin(), kept.end(), ascending(a, b));
}

}  // namespace geolloyd
