#include "core/regions/dual_repair.h"

#include <algorithm>
#include <utility>

#include "core/dual/seed_insertion.h"

namespace geolloyd {
namespace {

class RepairedDual {
 public:
  RepairedDual(const DualInput& input, Engine& engine, DualisedSeeds flawed,
               const std::function<bool()>& keep_going)
      : input_(input), engine_(engine), result_(std::move(flawed)), keep_going_(keep_going) {}

  DualisedSeeds run() {
    const std::size_t given = result_.seeds.size();
    const std::size_t most = given + (is_input_manifold() ? input_.mesh_graph.graph.node_count()
                                                          : most_seeds_added(given));
    while (any_removable(result_.dual.violations) && keep_going_()) {
      if (!add_seeds(most)) break;
      DualisedSeeds flawed = std::exchange(result_, {});
      flawed.surface = {};
      result_ = dualise_again(std::move(flawed.seeds));
    }
    if (result_.seeds.size() > given && !any_removable(result_.dual.violations)) settle(given);
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool is_input_manifold() const {
    const auto& edges = result_.surface.irregular_edges;
    return std::none_of(edges.begin(), edges.end(),
                        [](const IrregularEdge& edge) { return edge.triangles > 2; });
  }

  [[nodiscard]] DualisedSeeds dualise_again(std::vector<NodeId> seeds) {
    const Partition& partition = partition_of(engine_, seeds);
    return dualise(input_, partition, std::move(seeds));
  }

  // Stops at `most` seeds.
  bool add_seeds(std::size_t most) {
    const std::size_t before = result_.seeds.size();
    std::vector<bool> is_added(input_.mesh_graph.graph.node_count(), false);
    for (const SeedInsertion& insertion :
         leave_out_neighbours(find_seed_insertions(result_.surface, result_.dual), before)) {
      if (result_.seeds.size() == most) break;
      const NodeId node = node_at(input_.mesh_graph, result_.surface.vertex_count, insertion.point);
      if (!is_added[node]) result_.seeds.push_back(node);
      is_added[node] = true;
    }
    return result_.seeds.size() > before;
  }

  // Moves the seeds from `first_new` on, and those of the regions they border on, toward the
  // centroids of their regions. Seeds whose moving brings violations back stay.
  void settle(std::size_t first_new) {
    constexpr int attempts = 4;
    std::vector<std::uint8_t> keeps_seed;
    for (int attempt = 0; attempt < attempts && keep_going_(); ++attempt) {
      const Partition& partition = partition_of(engine_, result_.seeds);
      if (attempt == 0) keeps_seed = far_from(first_new, partition);
      std::vector<NodeId> moved = result_.seeds;
      engine_.macrostep(moved, {keeps_seed, true, true},
                        [this](std::uint32_t) { return keep_going_(); });
      if (moved == result_.seeds) return;
      DualisedSeeds settled = dualise_again(std::move(moved));
      if (!any_removable(settled.dual.violations) &&
          settled.dual.violations.size() <= result_.dual.violations.size()) {
        result_ = std::move(settled);
        continue;
      }
      for (const ClosedBallViolation& violation : settled.dual.violations) {
        for (const RegionId r : violation.regions) {
          if (r != no_id) keeps_seed[r] = 1;
        }
      }
    }
  }

  // Large regions stay as well: their seeds would go a long way, and each step is a search.
  [[nodiscard]] std::vector<std::uint8_t> far_from(std::size_t first_new,
                                                   const Partition& partition) const {
    const Graph& graph = input_.mesh_graph.graph;
    constexpr std::size_t most_nodes = 1 << 13;
    const std::vector<Key>& key = partition.key;
    std::vector<std::size_t> nodes(result_.seeds.size(), 0);
    for (const Key k : key) {
      if (k != unreached) ++nodes[region_of(k)];
    }
    std::vector<std::uint8_t> keeps_seed(result_.seeds.size(), 1);
    for (NodeId v = 0; v < graph.node_count(); ++v) {
      if (region_of(key[v]) < first_new || key[v] == unreached) continue;
      for (const NodeId u : graph.neighbours(v)) keeps_seed[region_of(key[u])] = 0;
    }
    for (std::size_t r = 0; r < keeps_seed.size(); ++r) {
      if (r >= first_new) keeps_seed[r] = 0;
      if (nodes[r] > most_nodes) keeps_seed[r] = 1;
    }
    return keeps_seed;
  }

  const DualInput& input_;
  Engine& engine_;
  DualisedSeeds result_;
  const std::function<bool()>& keep_going_;
};

}  // namespace

DualisedSeeds dualise(const DualInput& input, const Partition& partition,
                      std::vector<NodeId> seeds) {
  DualisedSeeds result{std::move(seeds), {}, {}};
  result.surface = make_region_surface(input.mesh, input.edges, input.mesh_graph, partition,
                                       result.seeds.size());
  result.dual = make_dual(result.surface, input.executor);
  return result;
}

std::size_t most_seeds_added(std::size_t regions) {
  return 2 * regions + 64;
}

DualisedSeeds repair_dual(const DualInput& input, Engine& engine, DualisedSeeds flawed,
                          const std::function<bool()>& keep_going) {
  return RepairedDual(input, engine, std::move(flawed), keep_going).run();
}

}  // namespace geolloyd
