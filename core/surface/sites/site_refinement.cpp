#include "core/surface/sites/site_refinement.h"

#include <algorithm>
#include <limits>

#include "core/base/loops.h"
#include "core/base/sorting.h"

namespace geolloyd {
namespace {

// Free vertices of one patch, ascending, and the area up to each.
struct VertexAreas {
  std::vector<VertexId> vertices;
  std::vector<double> up_to = {0};

  void add(const FineMesh& mesh, VertexId v) {
    constexpr double least = 1e-30;  // so that no two vertices are in one place of the sum
    double area = least;
    for (const TriangleId t : mesh.triangles_at(v)) area += mesh.sized_area(t) / 3;
    vertices.push_back(v);
    up_to.push_back(up_to.back() + area);
  }
  // At a share of the whole area.
  [[nodiscard]] std::size_t at(double share) const {
    const auto above = std::upper_bound(up_to.begin(), up_to.end(), up_to.back() * share);
    const auto index = static_cast<std::size_t>(above - up_to.begin());
    return std::clamp(index, std::size_t{1}, vertices.size()) - 1;
  }
};

}  // namespace

void start_sites(const LevelMesh& level, std::span<const std::size_t> wanted_free,
                 const CurveSites& at_curves, SurfaceSites& sites, std::vector<RegionId>& labels) {
  labels.assign(level.patch.size(), no_id);
  sites = SurfaceSites(at_curves.sites);
  std::vector<VertexAreas> patches(wanted_free.size());
  for (VertexId v = 0; v < level.patch.size(); ++v) {
    if (level.is_on_curve[v] == 0) patches[level.patch[v]].add(*level.mesh, v);
  }
  for (PatchId p = 0; p < patches.size(); ++p) {
    const std::size_t count = std::min(wanted_free[p], patches[p].vertices.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
      const std::size_t last = patches[p].vertices.size() - (count - i);
      next = std::clamp(patches[p].at(share), next, last);
      const VertexId v = patches[p].vertices[next++];
      labels[v] = static_cast<RegionId>(sites.size());
      sites.add(level.mesh->positions[v], p);
    }
  }
  label_curve_vertices(level, at_curves, labels);
}

std::vector<Adjacency> adjacent_cells(const LevelMesh& level, std::span<const RegionId> labels) {
  std::vector<Adjacency> found;
  for (const Triangle& t : level.mesh->triangles) {
    const auto free =
        std::find_if(t.begin(), t.end(), [&](VertexId v) { return level.is_on_curve[v] == 0; });
    const PatchId patch = level.patch[free != t.end() ? *free : t[0]];
    for (std::size_t c = 0; c < 3; ++c) {
      const RegionId a = labels[t[c]];
      const RegionId b = labels[t[(c + 1) % 3]];
      if (a != b && a != no_id && b != no_id) found.push_back({ascending(a, b), patch});
    }
  }
  sort_and_deduplicate(found);
  return found;
}

Refinement refine_sites(const SurfaceSites& old, std::span<const Adjacency> adjacent,
                        std::span<const std::array<RegionId, 2>> on_curves,
                        const CurveSites& at_curves, std::span<const Metric> metric) {
  const auto midway = [&](RegionId a, RegionId b) -> Vec3 {
    const Vec3& p = old.positions[a];
    const Vec3& q = old.positions[b];
    if (metric.empty()) return (p + q) / 2;
    return p + (metric[a] + metric[b]).solve(metric[b] * Vec3(q - p));
  };
  Refinement result{SurfaceSites(at_curves.sites), {}};
  result.child_sites.resize(old.size());
  for (std::size_t r = old.on_curves; r < old.size(); ++r) {
    result.child_sites[r].push_back(static_cast<RegionId>(result.sites.size()));
    result.sites.add(old.positions[r], old.patch[r]);
  }
  for (const auto& [pair, patch] : adjacent) {
    if (std::binary_search(on_curves.begin(), on_curves.end(), pair)) continue;
    for (const RegionId r : pair) {
      result.child_sites[r].push_back(static_cast<RegionId>(result.sites.size()));
    }
    result.sites.add(midway(pair[0], pair[1]), patch);
  }
  return result;
}

std::vector<RegionId> inherit_labels(const LevelMesh& level, const Refinement& refinement,
                                     std::span<const RegionId> old_label,
                                     std::span<const VertexId> stands_for, Executor& executor) {
  std::vector<RegionId> labels(level.patch.size(), no_id);
  parallel_for(executor, labels.size(), small_items, [&](std::size_t v) {
    const RegionId old = old_label[stands_for[v]];
    if (old == no_id) return;
    double least = std::numeric_limits<double>::infinity();
    for (const RegionId r : refinement.child_sites[old]) {
      if (refinement.sites.patch[r] != level.patch[v]) continue;
      const Vec3 away = level.mesh->positions[v] - refinement.sites.positions[r];
      const double square = level.mesh->square_at(static_cast<VertexId>(v), away);
      if (square < least) {
        least = square;
        labels[v] = r;
      }
    }
  });
  return labels;
}

void label_curve_vertices(const LevelMesh& level, const CurveSites& at_curves,
                          std::vector<RegionId>& labels) {
  for (std::size_t i = 0; i < level.curve_vertices.size(); ++i) {
    labels[level.curve_vertices[i]] = at_curves.label[i];
  }
}

}  // namespace geolloyd
