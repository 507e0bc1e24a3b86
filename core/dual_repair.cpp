#include "core/dual_repair.h"

#include <algorithm>

#include "core/dual_remedies.h"

namespace geolloyd {
namespace {

class Repairing {
 public:
  Repairing(const Mesh& mesh, const MeshEdges& edges, const MeshGraph& mesh_graph, Engine& engine,
            std::span<const NodeId> seeds)
      : mesh_(mesh), edges_(edges), mesh_graph_(mesh_graph), engine_(engine) {
    result_.seeds.assign(seeds.begin(), seeds.end());
  }

  DualRepair run(bool repair, const std::function<bool()>& keep_going) {
    const std::size_t given = result_.seeds.size();
    dualise();
    while (repair && !result_.dual.obstacles.empty() && keep_going()) {
      if (!add_seeds()) break;
      dualise();
      ++result_.rounds;
    }
    result_.added = result_.seeds.size() - given;
    if (result_.added > 0 && result_.dual.obstacles.empty()) settle(given, keep_going);
    return std::move(result_);
  }

 private:
  void dualise() {
    engine_.partition(result_.seeds);
    result_.surface =
        spread_regions(mesh_, edges_, mesh_graph_, engine_.current(), result_.seeds.size());
    result_.dual = make_dual(result_.surface);
  }

  // Those of one obstacle, but no two obstacles that concern the same region: one seed may mend
  // both.
  bool add_seeds() {
    constexpr std::array<RegionId, 3> nobody = {no_id, no_id, no_id};
    std::vector<std::array<RegionId, 3>> taken_by(result_.seeds.size(), nobody);
    for (const Remedy& remedy : find_remedies(result_.surface, result_.dual)) {
      const auto is_open = [&](RegionId r) {
        return r == no_id || taken_by[r] == nobody || taken_by[r] == remedy.regions;
      };
      if (!std::all_of(remedy.regions.begin(), remedy.regions.end(), is_open)) continue;
      for (const RegionId r : remedy.regions) {
        if (r != no_id) taken_by[r] = remedy.regions;
      }
      const NodeId node = node_at(mesh_graph_, mesh_.vertex_count(), remedy.point);
      const auto added = std::span(result_.seeds).subspan(taken_by.size());
      if (std::find(added.begin(), added.end(), node) == added.end()) result_.seeds.push_back(node);
    }
    return result_.seeds.size() > taken_by.size();
  }

  // Moves the seeds from `first_new` on, and those of the regions they border on, toward the
  // centroids of their regions. Seeds whose moving brings obstacles back stay.
  void settle(std::size_t first_new, const std::function<bool()>& keep_going) {
    constexpr int attempts = 6;
    std::vector<std::uint8_t> keeps_seed = far_from(first_new);
    for (int attempt = 0; attempt < attempts && keep_going(); ++attempt) {
      engine_.partition(result_.seeds);
      DualRepair good = result_;
      engine_.macrostep(result_.seeds, {keeps_seed, true, true},
                        [](std::uint32_t) { return true; });
      if (result_.seeds == good.seeds) return;
      dualise();
      if (result_.dual.obstacles.empty()) continue;
      for (const Obstacle& obstacle : result_.dual.obstacles) {
        for (const RegionId r : obstacle.regions) {
          if (r != no_id) keeps_seed[r] = 1;
        }
      }
      result_ = std::move(good);
    }
  }

  [[nodiscard]] std::vector<std::uint8_t> far_from(std::size_t first_new) const {
    const Graph& graph = mesh_graph_.graph;
    const std::vector<Key>& key = engine_.current().key;
    std::vector<std::uint8_t> keeps_seed(result_.seeds.size(), 1);
    for (NodeId v = 0; v < graph.node_count(); ++v) {
      if (region_of(key[v]) < first_new || key[v] == unreached) continue;
      for (const NodeId u : graph.neighbours(v)) keeps_seed[region_of(key[u])] = 0;
    }
    for (std::size_t r = first_new; r < keeps_seed.size(); ++r) keeps_seed[r] = 0;
    return keeps_seed;
  }

  const Mesh& mesh_;
  const MeshEdges& edges_;
  const MeshGraph& mesh_graph_;
  Engine& engine_;
  DualRepair result_;
};

}  // namespace

DualRepair make_dual_of(const Mesh& mesh, const MeshEdges& edges, const MeshGraph& mesh_graph,
                        Engine& engine, std::span<const NodeId> seeds, bool repair,
                        const std::function<bool()>& keep_going) {
  return Repairing(mesh, edges, mesh_graph, engine, seeds).run(repair, keep_going);
}

}  // namespace geolloyd
