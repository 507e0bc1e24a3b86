#include "tools/run/remesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/formats/vertex_list.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_measure.h"
#include "core/mesh/properties.h"
#include "core/surface/cells/reference_surface_engine.h"
#include "core/surface/result/remesh.h"
#include "core/surface/sizing/field_metric.h"
#include "core/surface/sizing/sizing.h"
#include "core/text/file_io.h"
#include "geolloyd/errors.h"
#include "parallel/surface/parallel_surface_engine.h"
#include "tools/evaluation/surface_distance.h"
#include "tools/run/attribute_transfer.h"
#include "tools/system/interrupt.h"

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

// make(options) makes a remesh.
template <class Make>
TimedRemesh timed(Make&& make, RemeshOptions options, ProgressLine& progress) {
  progress.stage("preparing the surface");
  const Stopwatch start;
  std::optional<Stopwatch> first_move;
  Stopwatch last_move;
  options.progress = [&](const RemeshProgress& p) {
    last_move = Stopwatch();
    if (!first_move) first_move = last_move;
    progress.show(p);
    return !interrupted();
  };
  TimedRemesh timed;
  timed.remesh = make(options);
  timed.seconds.prepare = first_move.value_or(last_move).since(start);
  timed.seconds.move = last_move.since(first_move.value_or(last_move));
  timed.seconds.assemble = last_move.seconds();
  return timed;
}

}  // namespace

MakeSurfaceEngine make_surface_engines(EngineKind kind, Scheduler& scheduler) {
  if (kind == EngineKind::reference) return make_reference_surface_engine;
  return
      [&scheduler](const FineMesh& mesh) { return make_parallel_surface_engine(mesh, scheduler); };
}

LoadedInput load_surface(const std::filesystem::path& file, Scheduler& scheduler,
                         ProgressLine& progress, const ReadOptions& options,
                         const RepairArguments& repair) {
  progress.stage("reading " + file.string());
  LoadedInput loaded = load_input(file, scheduler, options, repair);
  if (!(loaded.input.facts.area > 0)) {
    throw InvalidInput(file.string() + ": no triangle with an area, so nothing to remesh");
  }
  return loaded;
}

FeatureOptions read_features(const FeatureArguments& arguments, const LoadedInput& loaded) {
  FeatureOptions features;
  features.creases = arguments.creases;
  features.crease_angle = arguments.crease_angle;
  const Mesh& mesh = loaded.input.mesh();
  if (!arguments.edges_file.empty()) {
    features.edges = parse_edge_list(read_file(arguments.edges_file), arguments.edges_file.string(),
                                     mesh, loaded.edges);
  }
  if (!arguments.fixed_file.empty()) {
    features.fixed_vertices =
        parse_vertex_list(read_file(arguments.fixed_file), arguments.fixed_file.string(), mesh);
  }
  if (!arguments.labels.empty()) {
    features.groups = label_groups(mesh, loaded.input.loaded.properties, arguments.labels);
  }
  return features;
}

SizingOptions read_sizing(const SizingArguments& arguments, const LoadedInput& loaded) {
  SizingOptions sizing;
  sizing.adapt = arguments.adapt;
  sizing.growth = arguments.growth;
  const auto read = [&](const std::filesystem::path& file) {
    if (file.empty()) return std::vector<double>();
    return parse_vertex_values(read_file(file), file.string(), loaded.input.mesh().vertex_count());
  };
  sizing.edge_lengths = read(arguments.lengths_file);
  sizing.densities = read(arguments.densities_file);
  return sizing;
}

std::size_t about_how_many(const LoadedInput& loaded, const RemeshOptions& options,
                           Scheduler& scheduler) {
  if (options.vertex_count > 0) return options.vertex_count;
  double spacing = options.edge_length;
  if (!options.sizing.edge_lengths.empty() || !options.field.empty()) {
    spacing = find_sizing(loaded.input.mesh(), loaded.edges, options, scheduler).spacing;
  }
  const double count = sites_at(loaded.input.facts.area, spacing);
  constexpr double most = std::numeric_limits<std::uint32_t>::max();
  if (!(count < most)) {
    throw InvalidInput(fmt::format(
        "{} {:g}: the remesh would have more than {:.0f} vertices; the bounding box's diagonal is "
        "{:g}",
        options.edge_length > 0 ? "--edge-length" : "--sizing: edges of about", spacing, most,
        loaded.input.facts.bounding_diagonal));
  }
  return std::max<std::size_t>(4, static_cast<std::size_t>(count));
}

TimedRemesh time_remesh(const LoadedInput& loaded, RemeshOptions options,
                        const MakeSurfaceEngine& make_engine, Scheduler& scheduler,
                        ProgressLine& progress) {
  const auto make = [&](const RemeshOptions& observed) {
    return make_remesh(loaded.input.mesh(), loaded.edges, observed, make_engine, scheduler);
  };
  return timed(make, std::move(options), progress);
}

TimedRemesh time_last_remesh(LoadedInput& loaded, RemeshOptions options,
                             const MakeSurfaceEngine& make_engine, Scheduler& scheduler,
                             ProgressLine& progress) {
  const auto make = [&](const RemeshOptions& observed) {
    return make_remesh(loaded.input.mesh(), std::move(loaded.edges), observed, make_engine,
                       scheduler);
  };
  return timed(make, std::move(options), progress);
}

RemeshFigures judge_remesh(const LoadedInput& loaded, const Remesh& remesh,
                           std::span<const TangentSpace> field, Scheduler& scheduler) {
  constexpr std::size_t samples = 25'000;
  RemeshFigures figures;
  const MeshEdges edges = find_edges(remesh.mesh, scheduler);
  figures.quality = measure_quality(remesh.mesh, edges);
  const std::vector<Metric> shape = shapes_at(loaded.input.mesh(), shapes_of(field), remesh.places);
  if (!shape.empty()) figures.in_metric = measure_quality(remesh.mesh, edges, shape);
  if (!remesh.edge_lengths.empty()) figures.length_ratios = measure_ratios(remesh, edges, shape);
  if (remesh.mesh.triangles.empty()) return figures;
  const Mesh& mesh = loaded.input.mesh();
  figures.samples = samples;
  figures.distance =
      measure_distance_one_way(scheduler, mesh, loaded.edges, remesh.mesh, figures.samples);
  const MeshFacts& facts = loaded.input.facts;
  const PartTopology parts = remesh.topology.total();
  const bool is_closed = facts.boundary_edges + facts.non_manifold_edges +
                             facts.inconsistent_edges + facts.duplicate_triangles ==
                         0;
  if (is_closed && remesh.is_manifold() && parts.boundary_loops == 0) {
    const double volume = enclosed_volume(mesh);
    if (volume != 0) figures.volume_error = enclosed_volume(remesh.mesh) / volume - 1;
  }
  return figures;
}

}  // namespace geolloyd
