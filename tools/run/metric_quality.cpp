#include "tools/run/metric_quality.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "core/base/loops.h"
#include "core/surface/cells/surface_engine.h"
#include "core/surface/result/site_places.h"
#include "core/surface/sites/site_levels.h"
#include "core/surface/sizing/field_metric.h"
#include "core/surface/sizing/sizing.h"
#include "core/surface/substrate/surface_input.h"
#include "parallel/surface/parallel_surface_engine.h"
#include "tools/evaluation/closest_places.h"
#include "tools/evaluation/point_queries.h"

namespace geolloyd {
namespace {

// Of the cells of the remesh's vertices on the surface, which is cut as finely as for a remesh with
// as many.
double energy_ratio(const Mesh& mesh, const MeshEdges& edges, std::span<const Metric> shape,
                    std::span<const TangentSpace> field, std::span<const SurfacePoint> places,
                    Scheduler& scheduler) {
  RemeshOptions options;
  options.vertex_count = places.size();
  options.field.assign(field.begin(), field.end());
  options.sizing.growth = std::numeric_limits<double>::infinity();
  const Sizing sizing = find_sizing(mesh, edges, options, scheduler);
  SurfaceInputOptions cut;
  cut.duplicates = edges.duplicates;
  cut.longest_edge = 0.6 * sizing.spacing;
  cut.sizes = sizing.sizes;
  cut.metric = shape;
  cut.vertex_limit = 1'000'000 + 20 * places.size() + 4 * mesh.vertex_count();
  const SurfaceInput input = make_surface_input(mesh, cut, scheduler);

  std::vector<Vec3> sites;
  sites.reserve(places.size());
  for (const SurfacePoint& place : places) {
    sites.push_back(input.frame.to_unit(position_of(mesh, place)));
  }
  const NearestSite nearest(sites, scheduler.threads());
  std::vector<RegionId> labels(input.fine.vertex_count());
  parallel_for(scheduler, labels.size(), small_items,
               [&](std::size_t v) { labels[v] = nearest.find(input.fine.positions[v]); });
  const auto engine = make_parallel_surface_engine(input.fine, scheduler);
  engine->assign(std::move(labels), std::vector<std::uint8_t>(input.fine.vertex_count(), 0));
  const CellEnergies energies(input.fine, engine->evaluate(sites));
  double sum = 0;
  for (std::size_t r = 0; r < sites.size(); ++r) sum += energies.at(r, sites[r]);
  return sum / energy_of_hexagonal_tiling(input.fine.whole_sized_area, sites.size());
}

}  // namespace

MetricQuality judge_in_metric(const Mesh& remesh, const MeshEdges& edges, const Mesh& original,
                              const MeshEdges& original_edges, std::span<const TangentSpace> field,
                              Scheduler& scheduler) {
  const std::vector<SurfacePoint> places = closest_places(original, remesh.positions, scheduler);
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
      energy_ratio(original, original_edges, shape_of_mesh, field, places, scheduler);
  return result;
}

}  // namespace geolloyd
