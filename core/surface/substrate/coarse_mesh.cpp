#include "core/surface/substrate/coarse_mesh.h"

#include <algorithm>
#include <utility>

#include "core/base/bucketing.h"
#include "core/base/packing.h"
#include "core/mesh/spatial_order.h"

namespace geolloyd {
namespace {

class Coarsener {
 public:
  Coarsener(const FineMesh& finer, const Coarsening& coarsening, Executor& executor)
      : finer_(finer), coarsening_(coarsening), executor_(executor) {}

  CoarseMesh run() {
    find_runs();
    merge_within_runs();
    number_clusters();
    place_vertices();
    run_start_ = std::vector<VertexId>();  // nobody needs it any more
    collect_triangles();
    connect(result_.mesh, executor_);
    keep_edges();
    return std::move(result_);
  }

 private:
  // A run is a maximal sequence of vertices of one group in one cell.
  void find_runs() {
    const MortonGrid grid(unit_box());
    std::vector<std::uint64_t> cell(finer_.vertex_count());
    parallel_for(executor_, cell.size(), small_items, [&](std::size_t v) {
      constexpr int finest = 21;
      const int level = coarsening_.grid_level[v];
      cell[v] = grid.code(finer_.positions[v]) >> (3 * (finest - level));
    });
    run_start_ = pack_indices(executor_, cell.size(), [&](std::size_t v) {
      return v == 0 || cell[v] != cell[v - 1] || coarsening_.group[v] != coarsening_.group[v - 1];
    });
  }

  template <class Visit>
  void for_runs(Visit&& visit) {
    parallel_for(executor_, run_start_.size(), 256, [&](std::size_t i) {
      const auto end = i + 1 < run_start_.size() ? run_start_[i + 1]
                                                 : static_cast<VertexId>(finer_.vertex_count());
      visit(run_start_[i], end);
    });
  }

  void merge_within_runs() {
    root_.resize(finer_.vertex_count());
    for_runs([&](VertexId begin, VertexId end) {
      for (VertexId v = begin; v < end; ++v) root_[v] = v;
      for (VertexId v = begin; v < end; ++v) {
        for (const VertexId u : finer_.neighbours(v)) {
          if (u < begin || u >= v) continue;
          const VertexId a = root_of(u);
          const VertexId b = root_of(v);
          root_[std::max(a, b)] = std::min(a, b);
        }
      }
      for (VertexId v = begin; v < end; ++v) root_[v] = root_[root_[v]];  // smaller ones are done
    });
  }

  [[nodiscard]] VertexId root_of(VertexId v) const {
    while (root_[v] != v) v = root_[v];
    return v;
  }

  void number_clusters() {
    const std::vector<std::uint32_t> roots =
        pack_indices(executor_, root_.size(),
                     [&](std::size_t v) { return root_[v] == static_cast<VertexId>(v); });
    result_.vertex_of.resize(root_.size());
    parallel_for(executor_, roots.size(), small_items,
                 [&](std::size_t i) { result_.vertex_of[roots[i]] = static_cast<VertexId>(i); });
    parallel_for(executor_, root_.size(), small_items, [&](std::size_t v) {
      if (root_[v] != v) result_.vertex_of[v] = result_.vertex_of[root_[v]];
    });
    root_ = std::vector<VertexId>();
    result_.mesh.positions.assign(roots.size(), Vec3::Zero());
    if (!finer_.inverse_sizing.empty()) result_.mesh.inverse_sizing.assign(roots.size(), 0);
    if (!finer_.metric.empty()) result_.mesh.metric.assign(roots.size(), Metric::zero());
  }

  void place_vertices() {
    const bool has_inverse_sizing = !finer_.inverse_sizing.empty();
    const bool has_metric = !finer_.metric.empty();
    std::vector<double> weight(result_.mesh.positions.size(), 0);
    for_runs([&](VertexId begin, VertexId end) {
      for (VertexId v = begin; v < end; ++v) {
        double area = 0;
        for (const TriangleId t : finer_.triangles_at(v)) area += finer_.area(t);
        area += least_area;
        weight[result_.vertex_of[v]] += area;
        result_.mesh.positions[result_.vertex_of[v]] += area * finer_.positions[v];
        if (has_inverse_sizing) {
          result_.mesh.inverse_sizing[result_.vertex_of[v]] += area * finer_.inverse_sizing[v];
        }
        if (has_metric) result_.mesh.metric[result_.vertex_of[v]] += area * finer_.metric[v];
      }
    });
    parallel_for(executor_, weight.size(), small_items, [&](std::size_t i) {
      result_.mesh.positions[i] /= weight[i];
      if (has_inverse_sizing) result_.mesh.inverse_sizing[i] /= weight[i];
      if (has_metric) result_.mesh.metric[i] *= 1 / weight[i];
    });
  }

  [[nodiscard]] Triangle merged(std::size_t t) const {
    Triangle m{};
    for (std::size_t c = 0; c < 3; ++c) m[c] = result_.vertex_of[finer_.triangles[t][c]];
    std::rotate(m.begin(), std::min_element(m.begin(), m.end()), m.end());
    return m;
  }

  void collect_triangles() {
    FineMesh& mesh = result_.mesh;
    Bucketed<Triangle> by_smallest = bucket_sort<Triangle>(
        executor_, mesh.vertex_count(), finer_.triangle_count(), [&](std::size_t t, auto&& put) {
          const Triangle m = merged(t);
          if (has_three_vertices(m)) put(m[0], m);
        });
    std::vector<std::uint32_t> kept(mesh.vertex_count());
    parallel_for(executor_, kept.size(), small_items, [&](std::size_t v) {
      const std::span<Triangle> at = by_smallest[v];
      const auto same_vertices = [](const Triangle& a, const Triangle& b) {
        return ascending(a[1], a[2]) == ascending(b[1], b[2]);
      };
      std::sort(at.begin(), at.end(), [](const Triangle& a, const Triangle& b) {
        return std::pair(ascending(a[1], a[2]), a) < std::pair(ascending(b[1], b[2]), b);
      });
      kept[v] =
          static_cast<std::uint32_t>(std::unique(at.begin(), at.end(), same_vertices) - at.begin());
    });
    const Packing packing(executor_, kept.size(),
                          [&](std::size_t v) -> std::uint64_t { return kept[v]; });
    mesh.triangles.resize(packing.total());
    packing.for_each(executor_, [&](std::size_t v, std::uint64_t first) {
      std::copy_n(by_smallest[v].begin(), kept[v],
                  mesh.triangles.begin() + static_cast<std::ptrdiff_t>(first));
    });
  }

  void keep_edges() {
    FineMesh& mesh = result_.mesh;
    Bucketed<VertexId> around = bucket_sort<VertexId>(
        executor_, mesh.vertex_count(), finer_.vertex_count(), [&](std::size_t i, auto&& put) {
          const VertexId v = result_.vertex_of[i];
          VertexId last = no_id;
          for (const VertexId finer : finer_.neighbours(static_cast<VertexId>(i))) {
            const VertexId u = result_.vertex_of[finer];
            if (u != v && u != last) put(v, u);
            last = u;
          }
        });
    std::vector<std::uint32_t> kept(mesh.vertex_count());
    parallel_for(executor_, kept.size(), small_items, [&](std::size_t v) {
      const std::span<VertexId> at = around[v];
      std::sort(at.begin(), at.end());
      kept[v] = static_cast<std::uint32_t>(std::unique(at.begin(), at.end()) - at.begin());
    });
    mesh.first_neighbour = kept;
    mesh.first_neighbour.push_back(0);
    mesh.neighbour.resize(exclusive_scan<std::uint32_t>(executor_, mesh.first_neighbour));
    parallel_for(executor_, kept.size(), small_items, [&](std::size_t v) {
      std::copy_n(around[v].begin(), kept[v], mesh.neighbour.begin() + mesh.first_neighbour[v]);
    });
  }

  static constexpr double least_area = 1e-30;  // so that vertices without area have a mean, too

  const FineMesh& finer_;
  const Coarsening& coarsening_;
  Executor& executor_;
  std::vector<VertexId> run_start_;
  std::vector<VertexId> root_;  // per vertex: the smallest one it is merged with
  CoarseMesh result_;
};

}  // namespace

CoarseMesh coarsen(const FineMesh& finer, const Coarsening& coarsening, Executor& executor) {
  return Coarsener(finer, coarsening, executor).run();
}

}  // namespace geolloyd
