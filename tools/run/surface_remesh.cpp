#include "tools/run/surface_remesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/loops.h"
#include "core/base/stopwatch.h"
#include "core/formats/vertex_list.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_measure.h"
#include "core/mesh/properties.h"
#include "core/surface/creases.h"
#include "core/surface/reference_surface_engine.h"
#include "core/surface/surface_remesh.h"
#include "core/text/file_io.h"
#include "geolloyd/errors.h"
#include "parallel/surface/parallel_surface_engine.h"
#include "tools/evaluation/surface_distance.h"
#include "tools/render/picture.h"
#include "tools/run/carrying.h"
#include "tools/system/interrupt.h"
#include "tools/system/memory_estimate.h"
#include "tools/system/memory_limit.h"

namespace geolloyd {
namespace {

// How many vertices the surface on which sites move has, about: edges that are longer are halved
// again and again (core/surface/split_edges.h).
std::uint64_t estimate_fine_vertices(const LoadedInput& loaded, double longest,
                                     Scheduler& scheduler) {
  const Mesh& mesh = loaded.input.mesh();
  const auto pieces = [&](VertexId a, VertexId b) {
    const double length = norm(mesh.positions[a] - mesh.positions[b]);
    double count = 1;
    while (length > longest * count) count *= 2;
    return count;
  };
  // Whole numbers: sums are exact.
  auto added = parallel_reduce<double>(
      scheduler, loaded.edges.size(), small_items, [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t e = begin; e < end; ++e) {
          sum += pieces(loaded.edges.ends[e][0], loaded.edges.ends[e][1]) - 1;
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

// With features, edges are shorter (core/surface/surface_remesh.cpp). Whether there are any is only
// asked where it makes a difference.
std::uint64_t estimate_fine_vertices(const LoadedInput& loaded, std::size_t vertices,
                                     const FeatureOptions& features, Scheduler& scheduler) {
  const double root = std::sqrt(loaded.input.facts.area / static_cast<double>(vertices));
  const double spacing = std::sqrt(2 / std::sqrt(3.0)) * root;
  const std::uint64_t without = estimate_fine_vertices(loaded, 0.6 * root, scheduler);
  const std::uint64_t with = estimate_fine_vertices(loaded, 0.42 * spacing, scheduler);
  if (with <= without + without / 8) return with;
  const bool has_features =
      !find_features(loaded.input.mesh(), loaded.edges, features, spacing, scheduler).empty();
  return has_features ? with : without;
}

}  // namespace

MakeSurfaceEngine make_surface_engines(EngineKind kind, Scheduler& scheduler) {
  if (kind == EngineKind::reference) return make_reference_surface_engine;
  return
      [&scheduler](const FineMesh& mesh) { return make_parallel_surface_engine(mesh, scheduler); };
}

LoadedInput load_surface(const std::filesystem::path& file, Scheduler& scheduler,
                         ProgressLine& progress, const ReadOptions& options) {
  progress.stage("reading " + file.string());
  LoadedInput loaded = load_input(file, scheduler, options);
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

std::size_t vertices_of_edge_length(const LoadedInput& loaded, double edge_length) {
  const double count = 2 * loaded.input.facts.area / (std::sqrt(3.0) * edge_length * edge_length);
  constexpr double most = std::numeric_limits<std::uint32_t>::max();
  if (!(count < most)) {
    throw InvalidInput(fmt::format(
        "--edge-length {:g}: the remesh would have more than {:.0f} vertices; the bounding box's "
        "diagonal is {:g}",
        edge_length, most, loaded.input.facts.bounding_diagonal));
  }
  return std::max<std::size_t>(4, static_cast<std::size_t>(count));
}

std::uint64_t check_remesh_memory(const LoadedInput& loaded, std::size_t vertices,
                                  const FeatureOptions& features,
                                  const std::optional<PictureArguments>& picture,
                                  Scheduler& scheduler) {
  const Mesh& mesh = loaded.input.mesh();
  RemeshSize size;
  size.vertices = mesh.vertex_count();
  size.triangles = mesh.triangle_count();
  size.edges = loaded.edges.size();
  size.fine_vertices = estimate_fine_vertices(loaded, vertices, features, scheduler);
  size.remesh_vertices = vertices;
  size.threads = scheduler.threads();
  size.property_bytes = bytes_of(loaded.input.loaded.properties);
  if (picture) size.samples = count_samples(mesh, picture->view, picture->size, scheduler);
  const std::uint64_t bytes = memory_to_remesh(size);
  announce_memory(loaded.input.file.string(), bytes);
  return bytes;
}

TimedRemesh time_remesh(const LoadedInput& loaded, SurfaceRemeshOptions options,
                        const MakeSurfaceEngine& make_engine, Scheduler& scheduler,
                        ProgressLine& progress) {
  progress.stage("preparing the surface");
  const Stopwatch start;
  std::optional<Stopwatch> first_move;
  Stopwatch last_move;
  options.progress = [&](const SurfaceRemeshProgress& p) {
    last_move = Stopwatch();
    if (!first_move) first_move = last_move;
    progress.show(p);
    return !interrupted();
  };
  TimedRemesh timed;
  timed.remesh =
      make_surface_remesh(loaded.input.mesh(), loaded.edges, options, make_engine, scheduler);
  timed.seconds.prepare = first_move.value_or(last_move).since(start);
  timed.seconds.move = last_move.since(first_move.value_or(last_move));
  timed.seconds.assemble = last_move.seconds();
  return timed;
}

RemeshFigures judge_remesh(const LoadedInput& loaded, const SurfaceRemesh& remesh,
                           Scheduler& scheduler) {
  constexpr std::size_t samples = 25'000;
  RemeshFigures figures;
  figures.quality = measure_quality(remesh.mesh, find_edges(remesh.mesh, scheduler));
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
