#include "tools/evaluation/metric_quality.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "core/base/hexagonal_energy.h"
#include "core/base/loops.h"
#include "core/surface/cells/surface_engine.h"
#include "core/surface/result/site_places.h"
#include "core/surface/sizing/field_metric.h"
#include "core/surface/sizing/recipe.h"
#include "core/surface/substrate/surface_input.h"
#include "tools/evaluation/distances/closest_places.h"
#include "tools/evaluation/distances/point_queries.h"

namespace geolloyd {
namespace {

// Of the cells of the remesh's vertices on the surface, which is cut as finely as for a remesh with
// as many.
double energy_ratio(const Mesh& mesh, const MeshEdges& edges, std::span<const Metric> shape,
                    std::span<const TangentSpace> field, std::span<const SurfacePoint> places,
                    Runtime& runtime) {
  Executor& executor = runtime.executor();
  RemeshOptions options;
  options.vertex_count = places.size();
  options.field.assign(field.begin(), field.end());
  options.sizing.growth = std::numeric_limits<double>::infinity();
  const Sizing sizing = find_sizing(mesh, edges, options, executor);
  SurfaceInputOptions cut;
  cut.duplicates = edges.duplicates;
  cut.longest_edge = edge_per_side * sizing.spacing;  // of a rhombus: coarser than a remesh's
  cut.sizes = sizing.sizes;
  cut.metric = shape;
  cut.vertex_limit = vertex_limit_of_remesh(mesh, places.size());
  const SurfaceInput input = make_surface_input(mesh, cut, executor);

  std::vector<Vec3> sites;
  sites.reserve(places.size());
  for (const SurfacePoint& place : places) {
    sites.push_back(input.frame.to_unit(position_of(mesh, place)));
  }
  const NearestSite nearest(sites, executor.threads());
  std::vector<RegionId> labels(input.fine.vertex_count());
  parallel_for(executor, labels.size(), small_items,
               [&](std::size_t v) { labels[v] = nearest.find(input.fine.positions[v]); });
  const auto engine = runtime.make_surface_engine(input.fine);
  engine->assign(std::move(labels), std::vector<std::uint8_t>(input.fine.vertex_count(), 0));
  const CellEnergies energies(input.fine, engine->evaluate(sites));
  double sum = 0;
  for (std::size_t r = 0; r < sites.size(); ++r) sum += energies.at(r, sites[r]);
  const double area = input.fine.whole_sized_area;
  return sum / hexagonal_energy(area, area, sites.size());
}

}  // namespace

MetricQuality judge_in_metric(const Mesh& remesh, const MeshEdges& edges, const Mesh& original,
                              const MeshEdges& original_edges, std::span<const TangentSpace> field,
                              Runtime& runtime) {
  const std::vector<SurfacePoint> places =
      closest_places(original, remesh.positions, runtime.executor());
  const std::vector<Metric> shape_of_mesh = shapes_of(field);
  const std::vector<Metric> shape = shapes_at(original, shape_of_mesh, places);
  const std::vector<double> lengths = lengths_of(field);
  const auto length_at = [&](VertexId v) {
    double length = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      length += places[v].barycentric[c] * lengths[original.triangles[places[v].triangle][c]];
    }
    return length;
  };

  MetricQuality result;
  result.quality = measure_quality(remesh, edges, shape);
  std::vector<double> in_metric;
  in_metric.reserve(edges.size());
  for (const auto& [a, b] : edges.ends) {
    const Vec3 edge = remesh.positions[b] - remesh.positions[a];
    in_metric.push_back((0.5 * (shape[a] + shape[b])).length(edge) /
                        ((length_at(a) + length_at(b)) / 2));
    result.mean_length += in_metric.back();
  }
  result.mean_length /= static_cast<double>(edges.size());
  for (double& length : in_metric) length /= result.mean_length;
  result.lengths = summarised(std::move(in_metric));
  result.energy_ratio =
      energy_ratio(original, original_edges, shape_of_mesh, field, places, runtime);
  return result;
}

}  // namespace geolloyd
