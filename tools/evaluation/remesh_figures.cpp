#include "tools/evaluation/remesh_figures.h"

#include <utility>
#include <vector>

#include "core/course/remesh_warnings.h"
#include "core/surface/sizing/field_metric.h"
#include "tools/evaluation/distances/surface_distance.h"

namespace geolloyd {
namespace {

// In the metric of which each vertex has the shape, if there is one.
std::optional<EdgeLengthRatios> measure_ratios(const Remesh& remesh, const MeshEdges& edges,
                                               std::span<const Metric> shape) {
  if (edges.size() == 0) return std::nullopt;
  std::vector<double> ratio;
  ratio.reserve(edges.size());
  for (const auto& [a, b] : edges.ends) {
    const double asked = (remesh.edge_lengths[a] + remesh.edge_lengths[b]) / 2;
    const Vec3 edge = remesh.mesh.positions[a] - remesh.mesh.positions[b];
    ratio.push_back((shape.empty() ? norm(edge) : (0.5 * (shape[a] + shape[b])).length(edge)) /
                    asked);
  }
  return summarised(std::move(ratio));
}

bool is_closed(const MeshFacts& facts) {
  return facts.boundary_edges + facts.non_manifold_edges + facts.inconsistent_edges +
             facts.duplicate_triangles ==
         0;
}

}  // namespace

RemeshFigures judge_remesh(const Mesh& mesh, const MeshEdges& edges, const MeshFacts& facts,
                           const Remesh& remesh, std::span<const TangentSpace> field,
                           Executor& executor) {
  constexpr std::size_t samples = 25'000;
  RemeshFigures figures;
  const MeshEdges own_edges = find_edges(remesh.mesh, executor);
  figures.quality = measure_quality(remesh.mesh, own_edges);
  const std::vector<Metric> shape = shapes_at(mesh, shapes_of(field), remesh.places);
  if (!shape.empty()) figures.in_metric = measure_quality(remesh.mesh, own_edges, shape);
  if (!remesh.edge_lengths.empty()) {
    figures.length_ratios = measure_ratios(remesh, own_edges, shape);
  }
  if (remesh.mesh.triangles.empty() || remesh.interrupted) return figures;
  figures.samples = samples;
  figures.distance = measure_distance_one_way(executor, mesh, edges, remesh.mesh, samples);
  figures.volume_error = volume_error(mesh, is_closed(facts), remesh);
  return figures;
}

}  // namespace geolloyd
