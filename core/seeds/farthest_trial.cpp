#include "core/seeds/farthest_trial.h"

#include <new>

#include "core/base/huge_pages.h"

namespace geolloyd {

SparseNumbers::SparseNumbers(std::size_t size)
    : values_(static_cast<std::uint32_t*>(std::calloc(size, sizeof(std::uint32_t)))) {
  if (!values_) throw std::bad_alloc();
  prefer_huge_pages(values_.get(), size * sizeof(std::uint32_t));
}

FarthestTrial::FarthestTrial(const Graph& graph, const NearestDistances& nearest)
    : graph_(graph),
      nearest_(nearest),
      closeness_(graph.node_count()),
      buckets_(nearest.width_bits()) {}

bool FarthestTrial::is_farthest_around(NodeId node, std::uint32_t above) {
  reached_.assign(1, node);
  closeness_[node] = 1;
  bool is_farthest = true;
  for (std::size_t i = 0; i < reached_.size() && is_farthest; ++i) {
    for (const NodeId u : graph_.neighbours(reached_[i])) {
      if (nearest_.values()[u] <= above || closeness_[u] != 0) continue;
      is_farthest = is_farthest && !nearest_.is_farther(u, node);
      closeness_[u] = 1;
      reached_.push_back(u);
    }
  }
  for (const NodeId v : reached_) closeness_[v] = 0;
  return is_farthest;
}

bool FarthestTrial::search(NodeId node, std::vector<NodeDistance>& lowered) {
  const std::size_t first = lowered.size();
  closeness_[node] = ~std::uint32_t{0};
  lowered.push_back({node, 0});
  buckets_.push({node, 0});
  bool is_farthest = true;
  for (std::size_t b = 0; b < buckets_.end() && is_farthest; ++b) {
    buckets_.relax_bucket(b, no_id, [&](const NodeDistance& entry) {
      is_farthest = is_farthest && relax(entry, node, lowered);
    });
  }
  buckets_.clear();
  for (std::size_t i = first; i < lowered.size(); ++i) {
    lowered[i].distance = ~closeness_[lowered[i].node];
    closeness_[lowered[i].node] = 0;
  }
  if (!is_farthest) lowered.resize(first);
  return is_farthest;
}

bool FarthestTrial::relax(const NodeDistance& entry, NodeId from,
                          std::vector<NodeDistance>& lowered) {
  if (closeness_[entry.node] != ~entry.distance) return true;
  const std::uint32_t* distance = nearest_.values().data();
  for (ArcId a = graph_.first_arc[entry.node]; a < graph_.first_arc[entry.node + 1]; ++a) {
    const NodeId u = graph_.target[a];
    const std::uint32_t offered = entry.distance + graph_.length[a];
    if (offered >= distance[u]) continue;
    std::uint32_t& closeness = closeness_[u];
    if (closeness >= ~offered) continue;
    if (closeness == 0) {
      if (nearest_.is_farther(u, from)) return false;
      lowered.push_back({u, 0});
    }
    closeness = ~offered;
    prefetch_arcs(graph_, u);
    buckets_.push({u, offered});
  }
  return true;
}

}  // namespace geolloyd
