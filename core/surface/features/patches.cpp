#include "core/surface/features/patches.h"

#include <algorithm>
#include <utility>

#include "core/base/disjoint_sets.h"

namespace geolloyd {
namespace {

class PatchFinder {
 public:
  PatchFinder(const SurfaceInput& input, const FeatureCurves& curves, Executor& executor)
      : input_(input), fine_(input.fine), curves_(curves), executor_(executor) {}

  Patches run() {
    is_on_curve_.assign(fine_.vertex_count(), 0);
    for (const VertexId v : curves_.vertices) is_on_curve_[v] = 1;
    if (input_.feature_edges.empty()) {
      take_parts();
    } else {
      flood();
    }
    measure();
    find_vertices();
    find_sides();
    return std::move(result_);
  }

 private:
  void take_parts() {
    of_triangle_.resize(fine_.triangle_count());
    for (TriangleId t = 0; t < of_triangle_.size(); ++t) {
      of_triangle_[t] = input_.part[fine_.triangles[t][0]];
    }
    result_.patches.resize(input_.parts);
  }

  void flood() {
    DisjointSets sets(fine_.triangle_count(), executor_);
    parallel_for(executor_, fine_.triangle_count(), small_items, [&](std::size_t i) {
      const auto t = static_cast<TriangleId>(i);
      for (std::size_t c = 0; c < 3; ++c) {
        if (fine_.across_open[t][c] == no_id) continue;
        const auto edge =
            ascending(fine_.triangles[t][(c + 1) % 3], fine_.triangles[t][(c + 2) % 3]);
        for (const TriangleId u : fine_.triangles_at(edge[0])) {
          if (u < t && has_vertex(u, edge[1])) sets.unite(t, u);
        }
      }
    });
    of_triangle_.resize(fine_.triangle_count());
    for (TriangleId t = 0; t < of_triangle_.size(); ++t) {
      const TriangleId root = sets.find(t);  // the smallest, so it has its number
      if (root == t) result_.patches.emplace_back();
      of_triangle_[t] =
          root == t ? static_cast<PatchId>(result_.patches.size() - 1) : of_triangle_[root];
    }
  }
  [[nodiscard]] bool has_vertex(TriangleId t, VertexId v) const {
    const Triangle& corners = fine_.triangles[t];
    return corners[0] == v || corners[1] == v || corners[2] == v;
  }

  // Open triangles, edges that are on no curve, and vertices that are on none: together the patch
  // without its border, which has the Euler characteristic of the patch cut open along curves.
  void measure() {
    std::vector<std::int64_t> doubled(result_.patches.size(), 0);  // an edge counts half per side
    for (TriangleId t = 0; t < fine_.triangle_count(); ++t) {
      const PatchId p = of_triangle_[t];
      result_.patches[p].area += fine_.sized_area(t);
      doubled[p] += 2;
      for (const VertexId beyond : fine_.across_open[t]) doubled[p] -= beyond != no_id ? 1 : 0;
    }
    for (VertexId v = 0; v < fine_.vertex_count(); ++v) {
      if (is_on_curve_[v] == 0) doubled[of_triangle_[fine_.triangles_at(v)[0]]] += 2;
    }
    // A sub-resolution hole is closed by a disc: its vertices are as many as its edges, which are
    // not counted.
    for (const auto& subresolution_hole : curves_.subresolution_holes) {
      const auto edges = static_cast<std::int64_t>(subresolution_hole.size());
      doubled[of_triangle_[fine_.triangles_at(subresolution_hole.front())[0]]] += 2 - 2 * edges;
    }
    for (std::size_t p = 0; p < doubled.size(); ++p) {
      result_.patches[p].euler_characteristic = doubled[p] / 2;
    }
  }

  void find_vertices() {
    result_.of_vertex.resize(fine_.vertex_count());
    parallel_for(executor_, fine_.vertex_count(), small_items, [&](std::size_t i) {
      const auto at = fine_.triangles_at(static_cast<VertexId>(i));
      PatchId least = of_triangle_[at[0]];
      for (const TriangleId t : at) {
        const auto size = [&](PatchId p) { return std::pair(result_.patches[p].area, p); };
        if (size(of_triangle_[t]) < size(least)) least = of_triangle_[t];
      }
      result_.of_vertex[i] = least;
    });
  }

  void find_sides() {
    for (const FeatureCurve& curve : curves_.curves) {
      std::vector<PatchId>& sides = result_.beside.emplace_back();
      for (const TriangleId t : fine_.triangles_at(curve.vertices[0])) {
        if (!has_vertex(t, curve.vertices[1])) continue;
        sides.push_back(of_triangle_[t]);
        result_.patches[of_triangle_[t]].is_closed = false;
      }
    }
  }

  const SurfaceInput& input_;
  const FineMesh& fine_;
  const FeatureCurves& curves_;
  Executor& executor_;
  std::vector<std::uint8_t> is_on_curve_;
  std::vector<PatchId> of_triangle_;
  Patches result_;
};

}  // namespace

Patches find_patches(const SurfaceInput& input, const FeatureCurves& curves, Executor& executor) {
  return PatchFinder(input, curves, executor).run();
}

}  // namespace geolloyd
