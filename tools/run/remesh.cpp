#include "tools/run/remesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/loops.h"
#include "core/base/stopwatch.h"
#include "core/formats/vertex_list.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_measure.h"
#include "core/mesh/properties.h"
#include "core/surface/cells/reference_surface_engine.h"
#include "core/surface/features/creases.h"
#include "core/surface/result/remesh.h"
#include "core/surface/sizing/field_metric.h"
#include "core/surface/sizing/sizing.h"
#include "core/text/file_io.h"
#include "geolloyd/errors.h"
#include "parallel/surface/parallel_surface_engine.h"
#include "tools/evaluation/surface_distance.h"
#include "tools/render/picture.h"
#include "tools/evaluation/attribute_transfer.h"
#include "tools/system/interrupt.h"
#include "tools/system/memory_estimate.h"

namespace geolloyd {
namespace {

// How many vertices the surface on which sites move has, about: edges that are longer are halved
// again and again (core/surface/substrate/split_edges.h).
std::uint64_t estimate_fine_vertices(const Mesh& mesh, const MeshEdges& edges, double longest,
                                     Executor& scheduler) {
  const auto pieces = [&](VertexId a, VertexId b) {
    const double length = norm(mesh.positions[a] - mesh.positions[b]);
    double count = 1;
    while (length > longest * count) count *= 2;
    return count;
  };
  // Whole numbers: sums are exact.
  auto added = parallel_reduce<double>(scheduler, edges.size(), small_items,
                                       [&](std::size_t begin, std::size_t end) {
                                         double sum = 0;
                                         for (std::size_t e = begin; e < end; ++e) {
                                           sum += pieces(edges.ends[e][0], edges.ends[e][1]) - 1;
                                         }
                                         return sum;
                                       });
  added += parallel_reduce<double>(
      scheduler, mesh.triangle_count(), small_items, [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t t = begin; t < end; ++t) {
          const auto& [a, b, c] = mesh.triangles[t];
          const double rows = std::min({pieces(a, b), pieces(b, c), pieces(c, a)});
          sum += (rows - 1) * (rows - 2) / 2;
        }
        return sum;
      });
  // Measured: up to 1.65 times that, because halving makes diagonals that are long again.
  constexpr double diagonals = 1.7;
  constexpr double most = 1e12;
  return mesh.vertex_count() + static_cast<std::uint64_t>(std::min(most, diagonals * added));
}

bool varies(const RemeshOptions& options) {
  const SizingOptions& sizing = options.sizing;
  return !sizing.edge_lengths.empty() || !sizing.densities.empty() || sizing.adapt > 0 ||
         !options.field.empty();
}

// With features, edges are shorter (core/surface/result/remesh.cpp). Whether there are any is only
// asked where it makes a difference.
std::uint64_t estimate_fine_vertices(const Input& input, const MeshEdges& edges,
                                     std::size_t vertices, const RemeshOptions& options,
                                     Executor& scheduler) {
  const double area = input.facts.area;
  const double root = std::sqrt(area / static_cast<double>(vertices));
  const double spacing = spacing_of(area, static_cast<double>(vertices));
  const std::uint64_t without = estimate_fine_vertices(input.mesh(), edges, 0.6 * root, scheduler);
  const std::uint64_t with = estimate_fine_vertices(input.mesh(), edges, 0.42 * spacing, scheduler);
  if (varies(options)) {
    constexpr std::uint64_t per_vertex = 24;  // edges shorter than 0.42 spacings are not halved
    return std::max(with, input.mesh().vertex_count() + per_vertex * vertices);
  }
  if (with <= without + without / 8) return with;
  const bool has_features =
      !find_features(input.mesh(), edges, options.features, spacing, scheduler).empty();
  return has_features ? with : without;
}

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
                         ProgressLine& progress, const InputOptions& options,
                         const RepairArguments& repair) {
  progress.stage("reading " + file.string());
  LoadedInput loaded = load_input(file, scheduler, options, repair.wanted());
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

std::uint64_t estimate_remesh_memory(const Input& input, const MeshEdges& edges,
                                     std::size_t vertices, const RemeshOptions& options,
                                     const std::optional<PictureLook>& picture,
                                     Executor& scheduler) {
  const Mesh& mesh = input.mesh();
  RemeshSize size;
  size.vertices = mesh.vertex_count();
  size.triangles = mesh.triangle_count();
  size.edges = edges.size();
  size.fine_vertices = estimate_fine_vertices(input, edges, vertices, options, scheduler);
  size.remesh_vertices = vertices;
  size.has_field = !options.field.empty();
  size.threads = scheduler.threads();
  size.property_bytes = bytes_of(input.loaded.properties);
  if (picture) size.samples = count_samples(mesh, picture->view, picture->size, scheduler);
  return memory_to_remesh(size);
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
