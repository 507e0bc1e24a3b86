#include "tools/run/remesh.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/base/loops.h"
#include "core/formats/vertex_list.h"
#include "core/mesh/properties.h"
#include "core/surface/features/creases.h"
#include "core/surface/sizing/recipe.h"
#include "core/text/file_io.h"
#include "geolloyd/errors.h"
#include "tools/files/label_groups.h"
#include "tools/render/picture.h"
#include "tools/run/stages.h"
#include "tools/system/interrupt.h"
#include "tools/system/memory_estimate.h"

namespace geolloyd {
namespace {

// How many vertices the surface on which sites move has, about: edges that are longer are halved
// again and again (core/surface/substrate/split_edges.h).
std::uint64_t estimate_fine_vertices(const Mesh& mesh, const MeshEdges& edges, double longest,
                                     Executor& executor) {
  const auto pieces = [&](VertexId a, VertexId b) {
    const double length = norm(mesh.positions[a] - mesh.positions[b]);
    double count = 1;
    while (length > longest * count) count *= 2;
    return count;
  };
  // Whole numbers: sums are exact.
  auto added = parallel_reduce<double>(executor, edges.size(), small_items,
                                       [&](std::size_t begin, std::size_t end) {
                                         double sum = 0;
                                         for (std::size_t e = begin; e < end; ++e) {
                                           sum += pieces(edges.ends[e][0], edges.ends[e][1]) - 1;
                                         }
                                         return sum;
                                       });
  added += parallel_reduce<double>(
      executor, mesh.triangle_count(), small_items, [&](std::size_t begin, std::size_t end) {
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
                                     Executor& executor) {
  const double area = input.facts.area;
  const std::uint64_t without =
      estimate_fine_vertices(input.mesh(), edges, longest_edge(area, vertices), executor);
  const std::uint64_t with = estimate_fine_vertices(
      input.mesh(), edges, longest_edge_at_features(area, vertices), executor);
  if (varies(options)) {
    return std::max(with, input.mesh().vertex_count() + most_vertices_per_site * vertices);
  }
  if (with <= without + without / 8) return with;
  const bool has_features =
      !find_features(input.mesh(), edges, options.features,
                     spacing_of(area, static_cast<double>(vertices)), executor)
           .empty();
  return has_features ? with : without;
}

}  // namespace

LoadedInput load_surface(const RemeshRequest& request, Executor& executor, ProgressLine& progress) {
  progress.stage("reading " + request.mesh.string());
  LoadedInput loaded = load_input(
      request.mesh, executor,
      {request.carries_properties || !request.labels.empty(), request.format}, request.repair);
  if (!(loaded.input.facts.area > 0)) {
    throw InvalidInput(request.mesh.string() + ": no triangle with an area, so nothing to remesh");
  }
  return loaded;
}

RemeshOptions read_options(const RemeshRequest& request, const LoadedInput& loaded,
                           Executor& executor) {
  const Mesh& mesh = loaded.input.mesh();
  RemeshOptions options = request.options;
  const auto values_in = [&](const std::filesystem::path& file) {
    if (file.empty()) return std::vector<double>();
    return parse_vertex_values(read_file(file), file.string(), mesh.vertex_count());
  };
  options.sizing.edge_lengths = values_in(request.lengths_file);
  options.sizing.densities = values_in(request.densities_file);
  options.field = find_field(request.field, mesh, loaded.edges, executor);
  if (!request.edges_file.empty()) {
    options.features.edges = parse_edge_list(read_file(request.edges_file),
                                             request.edges_file.string(), mesh, loaded.edges);
  }
  if (!request.fixed_file.empty()) {
    options.features.fixed_vertices =
        parse_vertex_list(read_file(request.fixed_file), request.fixed_file.string(), mesh);
  }
  if (!request.labels.empty()) {
    options.features.groups = label_groups(mesh, loaded.input.loaded.properties, request.labels);
  }
  return options;
}

CourseHooks course_hooks(ProgressLine& progress, std::function<void(std::uint64_t)> budget) {
  return {[&progress](const std::string& stage) { progress.stage(stage); },
          [] { return !interrupted(); }, std::move(budget)};
}

std::uint64_t estimate_remesh_memory(const Input& input, const MeshEdges& edges,
                                     std::size_t vertices, const RemeshOptions& options,
                                     const std::optional<PictureLook>& picture,
                                     Executor& executor) {
  const Mesh& mesh = input.mesh();
  RemeshSize size;
  size.vertices = mesh.vertex_count();
  size.triangles = mesh.triangle_count();
  size.edges = edges.size();
  size.fine_vertices = estimate_fine_vertices(input, edges, vertices, options, executor);
  size.remesh_vertices = vertices;
  size.has_field = !options.field.empty();
  size.threads = executor.threads();
  size.property_bytes = bytes_of(input.loaded.properties);
  if (picture) size.samples = count_samples(mesh, picture->view, picture->size, executor);
  return memory_to_remesh(size);
}

}  // namespace geolloyd
