#include "core/voronoi/check_partition.h"

namespace geolloyd {
namespace {

using Finding = std::optional<std::string>;

class Checker {
 public:
  Checker(const Graph& graph, std::span<const NodeId> seeds, const Partition& partition,
          Regions regions)
      : graph_(graph), seeds_(seeds), partition_(partition), regions_(regions) {}

  [[nodiscard]] std::optional<PartitionDefect> seeds() const {
    for (RegionId r = 0; r < seeds_.size(); ++r) {
      const NodeId s = seeds_[r];
      if (partition_.key[s] != make_key(0, r)) {
        return PartitionDefect{s, "seed " + std::to_string(r) + " is not at distance 0 of itself"};
      }
      if (partition_.parent[s] != no_id) return PartitionDefect{s, "seed has a parent"};
    }
    return std::nullopt;
  }

  [[nodiscard]] Finding node(NodeId v) const {
    const Key key = partition_.key[v];
    if (distance_of(key) == unreached_distance) return unreached_node(v);
    if (region_of(key) >= seeds_.size()) return "region is none of the seeds'";
    if (seeds_[region_of(key)] != v && partition_.parent[v] == no_id) return "no parent";
    return arcs(v);
  }

 private:
  [[nodiscard]] Finding unreached_node(NodeId v) const {
    if (regions_ == Regions::locked && partition_.key[v] != unreached) {
      return "not reached from the seed of its region";
    }
    if (partition_.key[v] != unreached) return "unreached, but with a region";
    if (partition_.parent[v] != no_id) return "unreached, but with a parent";
    for (const NodeId u : graph_.neighbours(v)) {
      if (partition_.key[u] != unreached) return "unreached beside a reached node";
    }
    return std::nullopt;
  }

  // No arc into v may lower its key, and the first that attains it must come from its parent.
  [[nodiscard]] Finding arcs(NodeId v) const {
    const Key key = partition_.key[v];
    NodeId first_attaining = no_id;
    for (ArcId a = graph_.first_arc[v]; a < graph_.first_arc[v + 1]; ++a) {
      const NodeId u = graph_.target[a];
      const Key source = partition_.key[u];
      if (distance_of(source) == unreached_distance) continue;
      if (regions_ == Regions::locked && region_of(source) != region_of(key)) continue;
      const Key offered = along(source, graph_.length[a]);
      if (offered < key) return "node " + std::to_string(u) + " offers a smaller key";
      if (offered == key && first_attaining == no_id) first_attaining = u;
    }
    if (partition_.parent[v] != first_attaining)
      return "parent is not the smallest that attains it";
    return std::nullopt;
  }

  const Graph& graph_;
  std::span<const NodeId> seeds_;
  const Partition& partition_;
  Regions regions_;
};

}  // namespace

std::optional<PartitionDefect> check_partition(const Graph& graph, std::span<const NodeId> seeds,
                                               const Partition& partition, Regions regions) {
  if (partition.key.size() != graph.node_count() || partition.parent.size() != graph.node_count()) {
    return PartitionDefect{no_id, "not one key and one parent per node"};
  }
  const Checker checker(graph, seeds, partition, regions);
  if (auto defect = checker.seeds()) return defect;
  for (NodeId v = 0; v < graph.node_count(); ++v) {
    if (const Finding what = checker.node(v)) return PartitionDefect{v, *what};
  }
  return std::nullopt;
}

}  // namespace geolloyd
