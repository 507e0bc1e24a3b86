#include "core/surface/cells/cell_labels.h"

#include <algorithm>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/surface/cells/nearest_label.h"

namespace geolloyd {
namespace {

struct LabelComponent {
  VertexId first = no_id;  // smallest vertex
  std::uint32_t size = 0;
  bool has_fixed = false;

  [[nodiscard]] bool is_before(const LabelComponent& other) const {
    return std::tuple(has_fixed, size, other.first) >
           std::tuple(other.has_fixed, other.size, first);
  }
};

}  // namespace

void keep_one_component(const FineMesh& mesh, std::size_t sites,
                        std::span<const std::uint8_t> is_fixed, std::vector<RegionId>& labels,
                        Executor& executor) {
  DisjointSets sets(labels.size(), executor);
  parallel_for(executor, labels.size(), small_items, [&](std::size_t i) {
    const auto v = static_cast<VertexId>(i);
    for (const VertexId u : mesh.neighbours(v)) {
      if (u < v && labels[u] == labels[v]) sets.unite(u, v);
    }
  });
  std::vector<LabelComponent> component(labels.size());  // at its smallest vertex
  for (VertexId v = 0; v < labels.size(); ++v) {
    LabelComponent& of = component[sets.find(v)];
    of.first = std::min(of.first, v);
    ++of.size;
    of.has_fixed = of.has_fixed || is_fixed[v] != 0;
  }
  std::vector<LabelComponent> kept(sites);
  for (VertexId v = 0; v < labels.size(); ++v) {
    if (component[v].first != v || labels[v] == no_id) continue;
    LabelComponent& best = kept[labels[v]];
    if (best.first == no_id || component[v].is_before(best)) best = component[v];
  }
  for (VertexId v = 0; v < labels.size(); ++v) {
    if (labels[v] == no_id || is_fixed[v] != 0) continue;
    if (kept[labels[v]].first != sets.find(v)) labels[v] = no_id;
  }
}

void fill_gaps(const FineMesh& mesh, std::span<const Vec3> sites, std::vector<RegionId>& labels) {
  std::vector<VertexId> gaps;
  for (VertexId v = 0; v < labels.size(); ++v) {
    if (labels[v] == no_id) gaps.push_back(v);
  }
  while (!gaps.empty()) {
    std::vector<std::pair<VertexId, RegionId>> filled;
    std::vector<VertexId> left;
    for (const VertexId v : gaps) {
      const RegionId label = nearest_label(mesh, labels, sites, v).label;
      if (label != no_id) {
        filled.emplace_back(v, label);
      } else {
        left.push_back(v);
      }
    }
    if (filled.empty()) return;
    for (const auto& [v, label] : filled) labels[v] = label;
    gaps = std::move(left);
  }
}

std::vector<double> inverse_sizing_at_sites(const FineMesh& mesh, std::size_t sites,
                                            std::span<const RegionId> labels) {
  if (mesh.inverse_sizing.empty()) return {};
  std::vector<double> inverse_sizing(sites, 0);
  std::vector<std::uint32_t> count(sites, 0);
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    if (labels[v] == no_id) continue;
    inverse_sizing[labels[v]] += mesh.inverse_sizing[v];
    ++count[labels[v]];
  }
  for (std::size_t r = 0; r < sites; ++r) {
    inverse_sizing[r] = count[r] > 0 ? inverse_sizing[r] / count[r] : 1;
  }
  return inverse_sizing;
}

std::vector<Metric> metric_at_sites(const FineMesh& mesh, std::size_t sites,
                                    std::span<const RegionId> labels) {
  if (mesh.metric.empty()) return {};
  std::vector<Metric> metric(sites, Metric::zero());
  std::vector<std::uint32_t> count(sites, 0);
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    if (labels[v] == no_id) continue;
    const double inverse_sizing = mesh.inverse_sizing_at(v);
    metric[labels[v]] += inverse_sizing * inverse_sizing * mesh.metric[v];
    ++count[labels[v]];
  }
  for (std::size_t r = 0; r < sites; ++r) {
    metric[r] = count[r] > 0 ? 1.0 / count[r] * metric[r] : Metric{};
  }
  return metric;
}

std::vector<FarthestVertex> farthest_vertices(const FineMesh& mesh, std::span<const Vec3> sites,
                                              std::span<const std::uint8_t> is_fixed,
                                              std::span<const RegionId> labels) {
  std::vector<FarthestVertex> farthest(sites.size());
  for (VertexId v = 0; v < labels.size(); ++v) {
    if (labels[v] == no_id || is_fixed[v] != 0) continue;
    FarthestVertex& best = farthest[labels[v]];
    const double square = mesh.square_at(v, mesh.positions[v] - sites[labels[v]]);
    if (best.vertex == no_id || square > best.square_distance) best = {v, square};
  }
  return farthest;
}

}  // namespace geolloyd
