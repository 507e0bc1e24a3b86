#include "core/surface/substrate/surface_input.h"

#include <algorithm>
#include <utility>

#include "core/base/bucketing.h"
#include "core/base/disjoint_sets.h"
#include "core/base/sorting.h"
#include "core/mesh/cut_apart.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/spatial_order.h"
#include "core/surface/substrate/split_edges.h"

namespace geolloyd {
namespace {

struct UsableTriangles {
  Mesh mesh;
  std::vector<TriangleId> origin;
  EdgeSizes sizes;
};

UsableTriangles usable_triangles(const Mesh& mesh, const SurfaceInputOptions& options) {
  const std::span<const TriangleId> duplicates = options.duplicates;
  UsableTriangles usable;
  usable.mesh.positions = mesh.positions;
  usable.sizes.sizes.assign(options.sizes.begin(), options.sizes.end());
  usable.sizes.metric.assign(options.metric.begin(), options.metric.end());
  usable.mesh.triangles.reserve(mesh.triangle_count());
  usable.origin.reserve(mesh.triangle_count());
  auto duplicate = duplicates.begin();
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    if (duplicate != duplicates.end() && *duplicate == t) {
      ++duplicate;
    } else if (has_three_vertices(mesh.triangles[t])) {
      usable.mesh.triangles.push_back(mesh.triangles[t]);
      usable.origin.push_back(t);
    }
  }
  return usable;
}

class SurfaceInputBuilder {
 public:
  SurfaceInputBuilder(UsableTriangles usable, const SurfaceInputOptions& options,
                      Executor& executor)
      : usable_(std::move(usable)), options_(options), executor_(executor) {}

  SurfaceInput run() {
    result_.frame = frame_of(usable_.mesh, executor_);
    sort_vertices();
    sort_triangles();
    connect(result_.fine, executor_);
    find_boundary_edges();  // while all edges with two triangles are open
    find_feature_edges();
    close_edges(result_.fine, result_.feature_edges);
    find_parts();
    return std::move(result_);
  }

 private:
  void sort_vertices() {
    Mesh& mesh = usable_.mesh;
    std::vector<std::uint8_t> is_used(mesh.vertex_count(), 0);
    for (const Triangle& t : mesh.triangles) {
      for (const VertexId v : t) is_used[v] = 1;
    }
    parallel_for(executor_, mesh.vertex_count(), small_items, [&](std::size_t v) {
      mesh.positions[v] = result_.frame.to_unit(mesh.positions[v]);
    });
    std::vector<std::uint32_t> order = spatial_order(
        MortonGrid(unit_box()), mesh.vertex_count(),
        // The others may be outside the unit frame.
        [&](std::size_t v) { return is_used[v] != 0 ? mesh.positions[v] : Vec3(Vec3::Zero()); },
        executor_);
    std::erase_if(order, [&](std::uint32_t v) { return is_used[v] == 0; });
    std::vector<VertexId> place(mesh.vertex_count(), no_id);
    result_.fine.positions.resize(order.size());
    const std::vector<double>& sizes = usable_.sizes.sizes;
    const std::vector<Metric>& metric = usable_.sizes.metric;
    if (!sizes.empty()) result_.fine.inverse_sizing.resize(order.size());
    if (!metric.empty()) result_.fine.metric.resize(order.size());
    parallel_for(executor_, order.size(), small_items, [&](std::size_t i) {
      place[order[i]] = static_cast<VertexId>(i);
      result_.fine.positions[i] = mesh.positions[order[i]];
      if (!sizes.empty()) result_.fine.inverse_sizing[i] = 1 / sizes[order[i]];
      if (!metric.empty()) result_.fine.metric[i] = metric[order[i]];
    });
    for (const VertexId v : options_.fixed_vertices) {
      if (place[v] != no_id) result_.fixed_vertices.push_back(place[v]);
    }
    sort_and_deduplicate(result_.fixed_vertices);
    parallel_for(executor_, mesh.triangle_count(), small_items, [&](std::size_t t) {
      for (VertexId& v : mesh.triangles[t]) v = place[v];
    });
  }

  void sort_triangles() {
    FineMesh& fine = result_.fine;
    const std::vector<Triangle>& given = usable_.mesh.triangles;
    const auto by_smallest = bucket_sort<TriangleId>(
        executor_, fine.vertex_count(), given.size(), [&](std::size_t t, auto&& put) {
          put(std::min({given[t][0], given[t][1], given[t][2]}), static_cast<TriangleId>(t));
        });
    fine.triangles.resize(given.size());
    result_.origin.resize(given.size());
    parallel_for(executor_, given.size(), small_items, [&](std::size_t i) {
      const TriangleId t = by_smallest.entry[i];
      fine.triangles[i] = given[t];
      result_.origin[i] = usable_.origin[t];
    });
    usable_ = {};
  }

  void find_boundary_edges() {
    const FineMesh& fine = result_.fine;
    for (TriangleId t = 0; t < fine.triangle_count(); ++t) {
      for (std::size_t c = 0; c < 3; ++c) {
        if (fine.across_open[t][c] != no_id) continue;
        result_.boundary_edges.push_back(
            ascending(fine.triangles[t][(c + 1) % 3], fine.triangles[t][(c + 2) % 3]));
      }
    }
    std::sort(result_.boundary_edges.begin(), result_.boundary_edges.end());
  }

  // Splitting an edge leaves its halves between pieces of the same two triangles.
  void find_feature_edges() {
    if (options_.features.empty()) return;
    const FineMesh& fine = result_.fine;
    std::vector<std::vector<std::array<VertexId, 2>>> found(executor_.threads());
    parallel_for_ranges(executor_, fine.triangle_count(), small_items,
                        [&](std::size_t begin, std::size_t end, std::size_t worker) {
                          for (auto t = static_cast<TriangleId>(begin); t < end; ++t) {
                            for (std::size_t c = 0; c < 3; ++c) {
                              if (is_feature(t, c)) {
                                found[worker].push_back(ascending(fine.triangles[t][(c + 1) % 3],
                                                                  fine.triangles[t][(c + 2) % 3]));
                              }
                            }
                          }
                        });
    for (const auto& edges : found) {
      result_.feature_edges.insert(result_.feature_edges.end(), edges.begin(), edges.end());
    }
    sort_and_deduplicate(result_.feature_edges);
  }
  [[nodiscard]] bool is_feature(TriangleId t, std::size_t c) const {
    const FineMesh& fine = result_.fine;
    const VertexId beyond = fine.across_open[t][c];
    if (beyond == no_id) return false;
    const auto edge = ascending(fine.triangles[t][(c + 1) % 3], fine.triangles[t][(c + 2) % 3]);
    const auto at = fine.triangles_at(beyond);
    return std::any_of(at.begin(), at.end(), [&](TriangleId u) {
      const TrianglePair pair = ascending(result_.origin[t], result_.origin[u]);
      return u != t && has_edge(fine.triangles[u], edge) &&
             std::binary_search(options_.features.begin(), options_.features.end(), pair);
    });
  }
  static bool has_edge(const Triangle& t, const std::array<VertexId, 2>& edge) {
    return ascending(t[0], t[1]) == edge || ascending(t[1], t[2]) == edge ||
           ascending(t[2], t[0]) == edge;
  }

  void find_parts() {
    const FineMesh& fine = result_.fine;
    DisjointSets sets(fine.vertex_count(), executor_);
    parallel_for(executor_, fine.triangle_count(), small_items, [&](std::size_t t) {
      const auto& [a, b, c] = fine.triangles[t];
      sets.unite(a, b);
      sets.unite(b, c);
    });
    result_.part.resize(fine.vertex_count());
    for (VertexId v = 0; v < fine.vertex_count(); ++v) {
      const std::uint32_t root = sets.find(v);  // the smallest, so it has its number
      result_.part[v] =
          root == v ? static_cast<std::uint32_t>(result_.parts++) : result_.part[root];
    }
  }

  UsableTriangles usable_;
  const SurfaceInputOptions& options_;
  Executor& executor_;
  SurfaceInput result_;
};

}  // namespace

SurfaceFrame frame_of(const Mesh& mesh, Executor& executor) {
  const BoundingBox box = bounding_box(
      3 * mesh.triangle_count(),
      [&](std::size_t c) { return mesh.positions[mesh.triangles[c / 3][c % 3]]; }, executor);
  SurfaceFrame frame;
  frame.middle = box.middle();
  const double half = box.extent().maxCoeff() / 2;
  while (half * frame.scale > 1) frame.scale /= 2;
  while (half > 0 && half * frame.scale <= 0.5) frame.scale *= 2;
  return frame;
}

std::vector<std::int64_t> euler_characteristics(const SurfaceInput& input) {
  std::vector<std::int64_t> doubled(input.parts, 0);  // inner edges count half for each triangle
  for (const std::uint32_t part : input.part) doubled[part] += 2;
  for (const Triangle& t : input.fine.triangles) doubled[input.part[t[0]]] += 2 - 3;
  for (const auto& ends : input.boundary_edges) --doubled[input.part[ends[0]]];
  for (std::int64_t& x : doubled) x /= 2;
  return doubled;
}

SurfaceInput make_surface_input(const Mesh& mesh, const SurfaceInputOptions& options,
                                Executor& executor) {
  UsableTriangles usable = usable_triangles(mesh, options);
  const CutVertices cut = cut_apart(usable.mesh, executor);
  auto& [sizes, metric] = usable.sizes;
  for (const VertexId v : cut.copy_of) {
    if (!sizes.empty()) sizes.push_back(double{sizes[v]});
    if (!metric.empty()) metric.emplace_back(Metric{metric[v]});
  }
  split_long_edges(usable.mesh, usable.origin, usable.sizes, options.longest_edge,
                   options.vertex_limit);
  const bool was_cut_short =
      options.longest_edge > 0 && usable.mesh.vertex_count() >= options.vertex_limit;
  SurfaceInput input = SurfaceInputBuilder(std::move(usable), options, executor).run();
  input.vertices_cut = cut.vertices;
  input.was_cut_short = was_cut_short;
  return input;
}

}  // namespace geolloyd
