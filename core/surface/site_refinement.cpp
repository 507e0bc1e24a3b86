#include "core/surface/site_refinement.h"

#include <algorithm>
#include <limits>

#include "core/base/loops.h"

namespace geolloyd {
namespace {

// Free vertices of one part, ascending, and the area up to each.
struct VertexAreas {
  std::vector<VertexId> vertices;
  std::vector<double> up_to = {0};

  void add(const FineMesh& mesh, VertexId v) {
    constexpr double least = 1e-30;  // so that no two vertices are in one place of the sum
    double area = least;
    for (const TriangleId t : mesh.triangles_at(v)) area += mesh.area[t] / 3;
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
                 const OuterSites& outer, SurfaceSites& sites, std::vector<RegionId>& labels) {
  labels.assign(level.part.size(), no_id);
  sites = SurfaceSites(outer.sites, outer.part);
  std::vector<VertexAreas> parts(wanted_free.size());
  for (VertexId v = 0; v < level.part.size(); ++v) {
    if (level.is_outer[v] == 0) parts[level.part[v]].add(*level.mesh, v);
  }
  for (std::uint32_t part = 0; part < parts.size(); ++part) {
    const std::size_t count = std::min(wanted_free[part], parts[part].vertices.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
      const std::size_t last = parts[part].vertices.size() - (count - i);
      next = std::clamp(parts[part].at(share), next, last);
      const VertexId v = parts[part].vertices[next++];
      labels[v] = static_cast<RegionId>(sites.size());
      sites.add(level.mesh->positions[v], part);
    }
  }
  label_outer_vertices(level, outer, labels);
}

Refinement refine_sites(const SurfaceSites& old, std::span<const std::array<RegionId, 2>> adjacent,
                        std::span<const std::array<RegionId, 2>> on_chains,
                        const OuterSites& outer) {
  Refinement result{SurfaceSites(outer.sites, outer.part), {}};
  result.heirs.resize(old.size());
  for (std::size_t r = old.outer; r < old.size(); ++r) {
    result.heirs[r].push_back(static_cast<RegionId>(result.sites.size()));
    result.sites.add(old.positions[r], old.part[r]);
  }
  for (const auto& pair : adjacent) {
    if (std::binary_search(on_chains.begin(), on_chains.end(), pair)) continue;
    for (const RegionId r : pair) {
      result.heirs[r].push_back(static_cast<RegionId>(result.sites.size()));
    }
    result.sites.add((old.positions[pair[0]] + old.positions[pair[1]]) / 2, old.part[pair[0]]);
  }
  return result;
}

std::vector<RegionId> inherit_labels(const FineMesh& mesh, const Refinement& refinement,
                                     std::span<const RegionId> old_label,
                                     std::span<const VertexId> stands_for, Executor& executor) {
  std::vector<RegionId> labels(mesh.vertex_count(), no_id);
  parallel_for(executor, labels.size(), small_items, [&](std::size_t v) {
    const RegionId old = old_label[stands_for[v]];
    if (old == no_id) return;
    double least = std::numeric_limits<double>::infinity();
    for (const RegionId r : refinement.heirs[old]) {
      const Vec3 away = mesh.positions[v] - refinement.sites.positions[r];
      if (dot(away, away) < least) {
        least = dot(away, away);
        labels[v] = r;
      }
    }
  });
  return labels;
}

void label_outer_vertices(const LevelMesh& level, const OuterSites& outer,
                          std::vector<RegionId>& labels) {
  for (std::size_t i = 0; i < level.outer_vertices.size(); ++i) {
    labels[level.outer_vertices[i]] = outer.label[i];
  }
}

}  // namespace geolloyd
