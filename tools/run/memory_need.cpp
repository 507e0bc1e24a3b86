#include "tools/run/memory_need.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/loops.h"
#include "core/graph/graph.h"
#include "core/mesh/mesh_measure.h"
#include "core/properties/properties.h"
#include "core/surface/creases/creases.h"
#include "core/surface/sizing/recipe.h"
#include "core/surface/sizing/sizing.h"

namespace geolloyd {
namespace {

// Vertices that halving of all edges longer than `longest` adds
// (core/surface/substrate/split_edges.h): a triangle becomes pieces like itself until its shortest
// edge is short, and each of these is cut across its longer ones. Sums of whole numbers are exact.
double vertices_added(const Mesh& mesh, double longest, Executor& executor) {
  const auto pieces = [&](VertexId a, VertexId b) {
    const double length = norm(mesh.positions[a] - mesh.positions[b]);
    double count = 1;
    while (length > longest * count) count *= 2;
    return count;
  };
  const auto twice = parallel_reduce<double>(
      executor, mesh.triangle_count(), small_items, [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t t = begin; t < end; ++t) {
          const auto& [a, b, c] = mesh.triangles[t];
          const std::array<double, 3> edge = {pieces(a, b), pieces(b, c), pieces(c, a)};
          const double least = *std::min_element(edge.begin(), edge.end());
          sum += least * (edge[0] + edge[1] + edge[2] - 2 * least) - 1;
        }
        return sum;
      });
  return twice / 2;
}

bool varies(const RemeshOptions& options) {
  const SizingOptions& sizing = options.sizing;
  return !sizing.edge_lengths.empty() || !sizing.densities.empty() || sizing.adapt > 0 ||
         sizing.equal_error || !options.field.empty();
}

// Edges are shorter where there are features (core/surface/result/remesh.cpp). Whether there are
// any is only asked where it makes a difference. Where lengths vary, the finest parts may be
// anywhere: measured, up to 3.5 vertices in the square of the longest edge.
double vertices_added(const Mesh& mesh, const MeshEdges& edges, double area,
                      const RemeshOptions& options, std::uint64_t sites, Executor& executor) {
  const double spacing = spacing_of(area, static_cast<double>(sites));
  const auto added = [&](double longest) {
    return varies(options) ? 3.5 * area / (longest * longest)
                           : vertices_added(mesh, longest, executor);
  };
  const double most = added(longest_edge_at_features(area, sites));
  if (most == 0 || !find_features(mesh, edges, options.features, spacing, executor).empty()) {
    return most;
  }
  return added(longest_edge(area, sites));
}

}  // namespace

WorkSize size_of(const LoadedMesh& loaded) {
  WorkSize size;
  size.vertices = loaded.mesh.vertex_count();
  size.triangles = loaded.mesh.triangle_count();
  size.property_bytes = bytes_of(loaded.properties);
  return size;
}

std::uint64_t memory_to_relax(const Mesh& mesh, const MeshEdges& edges, GraphKind kind,
                              WorkSize size, Executor& executor) {
  size.threads = executor.threads();
  size.nodes =
      (has_vertices(kind) ? size.vertices : 0) + (has_triangles(kind) ? size.triangles : 0);
  std::uint64_t links = count_arcs(mesh, edges, kind, executor);
  check_arc_count(links);
  if (kind == GraphKind::triangle_dense) {  // a pair at an edge was counted there and at both ends
    links -= std::min<std::uint64_t>(links, 2 * edges.size());
  }
  size.arcs = 2 * links;
  size.sites = std::min(size.sites, size.nodes);
  return bytes_to_relax(size);
}

std::uint64_t memory_to_remesh(const Mesh& mesh, const MeshEdges& edges, double area,
                               const RemeshOptions& options, WorkSize size, Executor& executor) {
  const auto most = static_cast<double>(vertex_limit_of_remesh(mesh, size.sites));
  size.threads = executor.threads();
  size.has_field = !options.field.empty();
  size.fine_vertices =
      size.vertices + static_cast<std::uint64_t>(std::min(
                          most, vertices_added(mesh, edges, area, options, size.sites, executor)));
  return bytes_to_remesh(size);
}

}  // namespace geolloyd
