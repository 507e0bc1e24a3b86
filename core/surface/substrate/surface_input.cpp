#include "core/surface/substrate/surface_input.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/base/bucketing.h"
#include "core/base/disjoint_sets.h"
#include "core/base/sorting.h"
#include "core/mesh/closest_on_triangle.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/spatial_order.h"
#include "core/seams/cut_apart.h"
#include "core/surface/substrate/split_edges.h"
#include "core/surface/substrate/split_needles.h"

namespace geolloyd {
namespace {

struct UsableTriangles {
  Mesh mesh;
  std::vector<TriangleId> origin;
  EdgeSizes sizes;
  bool has_flips = false;
  std::vector<std::array<VertexId, 2>> feature_edges;  // where it has; else origins tell
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

void split(UsableTriangles& usable, const SurfaceInputOptions& options, Executor& executor) {
  auto& [mesh, origin, sizes, has_flips, feature_edges] = usable;
  const double longest = options.longest_edge;
  has_flips = options.most_pieces > 0 &&
              pieces_of_long_edges(mesh, sizes, longest, executor) > options.most_pieces;
  if (has_flips) {
    feature_edges =
        split_needles(mesh, origin, sizes, longest, options.vertex_limit, options.features);
  } else {
    split_long_edges(mesh, origin, sizes, longest, options.vertex_limit);
  }
}

class SurfaceInputBuilder {
 public:
  /// Of triangles in the unit frame.
  SurfaceInputBuilder(UsableTriangles usable, std::span<const TrianglePair> features,
                      std::span<const VertexId> fixed_vertices, Executor& executor)
      : usable_(std::move(usable)),
        features_(features),
        fixed_vertices_(fixed_vertices),
        executor_(executor) {}

  SurfaceInput run() {
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
    for (const VertexId v : fixed_vertices_) {
      if (place[v] != no_id) result_.fixed_vertices.push_back(place[v]);
    }
    sort_and_deduplicate(result_.fixed_vertices);
    parallel_for(executor_, mesh.triangle_count(), small_items, [&](std::size_t t) {
      for (VertexId& v : mesh.triangles[t]) v = place[v];
    });
    result_.has_flips = usable_.has_flips;
    for (const auto& [a, b] : usable_.feature_edges) {
      result_.feature_edges.push_back(ascending(place[a], place[b]));
    }
    sort_and_deduplicate(result_.feature_edges);
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
    if (features_.empty() || result_.has_flips) return;
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
             std::binary_search(features_.begin(), features_.end(), pair);
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
  std::span<const TrianglePair> features_;
  std::span<const VertexId> fixed_vertices_;
  Executor& executor_;
  SurfaceInput result_;
};

// Ascending.
std::vector<TrianglePair> triangles_at_features(const SurfaceInput& input) {
  std::vector<TriangleId> one(input.feature_edges.size(), no_id);  // per feature edge
  std::vector<TrianglePair> pairs;
  for (TriangleId t = 0; t < input.fine.triangle_count(); ++t) {
    const Triangle& corners = input.fine.triangles[t];
    for (std::size_t c = 0; c < 3; ++c) {
      const auto edge = ascending(corners[c], corners[(c + 1) % 3]);
      const auto at =
          std::lower_bound(input.feature_edges.begin(), input.feature_edges.end(), edge);
      if (at == input.feature_edges.end() || *at != edge) continue;
      TriangleId& other = one[static_cast<std::size_t>(at - input.feature_edges.begin())];
      if (other != no_id) pairs.push_back({other, t});
      other = t;
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// Whether one is to be split, for all that is known.
bool has_long_edges(const FineMesh& fine, std::span<const double> sizes, double longest) {
  if (!fine.metric.empty()) return true;
  return std::any_of(fine.triangles.begin(), fine.triangles.end(), [&](const Triangle& t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const VertexId a = t[c];
      const VertexId b = t[(c + 1) % 3];
      const double length = norm(fine.positions[a] - fine.positions[b]);
      if (!(length <= longest * std::min(sizes[a], sizes[b]))) return true;
    }
    return false;
  });
}

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
  split(usable, options, executor);
  const SurfaceFrame frame = frame_of(usable.mesh, executor);
  std::vector<Vec3>& positions = usable.mesh.positions;
  parallel_for(executor, positions.size(), small_items,
               [&](std::size_t v) { positions[v] = frame.to_unit(positions[v]); });
  const bool was_cut_short = options.longest_edge > 0 && positions.size() >= options.vertex_limit;
  SurfaceInput input =
      SurfaceInputBuilder(std::move(usable), options.features, options.fixed_vertices, executor)
          .run();
  input.frame = frame;
  input.vertices_cut = cut.vertices;
  input.was_cut_short = was_cut_short;
  return input;
}

std::vector<double> at_fine_vertices(const Mesh& mesh, const SurfaceInput& input,
                                     std::span<const double> values, Executor& executor) {
  const FineMesh& fine = input.fine;
  std::vector<double> result(fine.vertex_count());
  parallel_for(executor, result.size(), small_items, [&](std::size_t v) {
    const TriangleId t = fine.triangles_at(static_cast<VertexId>(v)).front();
    const auto& [a, b, c] = mesh.triangles[input.origin[t]];
    const auto away = [&](VertexId corner) {
      return Vec3(input.frame.to_unit(mesh.positions[corner]) - fine.positions[v]);
    };
    const auto [of_b, of_c] = barycentric_closest_to_origin({away(a), away(b), away(c)});
    result[v] = (1 - of_b - of_c) * values[a] + of_b * values[b] + of_c * values[c];
  });
  return result;
}

SurfaceInput with_sizes(SurfaceInput input, std::vector<double> sizes, SurfaceInputOptions options,
                        Executor& executor) {
  if (!has_long_edges(input.fine, sizes, options.longest_edge * input.frame.scale)) {
    for (double& size : sizes) size = 1 / size;
    input.fine.inverse_sizing = std::move(sizes);
    find_whole(input.fine, executor);
    return input;
  }
  // Pieces know the triangle of `input` they are of, so that edges along features are found again.
  const std::vector<TrianglePair> features = triangles_at_features(input);
  options.features = features;
  options.longest_edge *= input.frame.scale;
  UsableTriangles usable;
  usable.mesh.positions = std::move(input.fine.positions);
  usable.mesh.triangles = std::move(input.fine.triangles);
  usable.origin.resize(usable.mesh.triangles.size());
  std::iota(usable.origin.begin(), usable.origin.end(), TriangleId{0});
  usable.sizes = {std::move(sizes), std::move(input.fine.metric)};
  split(usable, options, executor);
  SurfaceInput resized =
      SurfaceInputBuilder(std::move(usable), features, input.fixed_vertices, executor).run();
  for (TriangleId& t : resized.origin) t = input.origin[t];
  resized.frame = input.frame;
  resized.has_flips = resized.has_flips || input.has_flips;
  resized.vertices_cut = input.vertices_cut;
  resized.was_cut_short = input.was_cut_short;
  return resized;
}

}  // namespace geolloyd
