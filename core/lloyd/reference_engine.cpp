#include "core/lloyd/reference_engine.h"

#include <algorithm>
#include <numeric>

#include "core/base/stopwatch.h"
#include "core/lloyd/seed_move.h"
#include "core/voronoi/dijkstra.h"
#include "core/voronoi/energy.h"
#include "core/voronoi/fingerprint.h"
#include "core/voronoi/forest.h"

namespace geolloyd {
namespace {

class ReferenceEngine final : public Engine {
 public:
  explicit ReferenceEngine(const Graph& graph)
      : graph_(graph),
        heap_(graph.node_count()),
        sums_{std::vector<std::uint64_t>(graph.node_count()),
              std::vector<std::uint64_t>(graph.node_count())} {}

  void partition(std::span<const NodeId> seeds) override {
    {
      const Timed timed(seconds_.free_search);
      search_free(graph_, seeds, heap_, partition_.key, settled_);
      partition_.parent.assign(graph_.node_count(), no_id);
      derive_parents(graph_, partition_.key, settled_, partition_.parent);
    }
    const Timed timed(seconds_.scoring);
    region_score_.assign(seeds.size(), 0);
    add_scores(graph_, partition_.key, settled_, region_score_);
  }

  [[nodiscard]] std::span<const Score> region_scores() const override { return region_score_; }

  [[nodiscard]] std::uint64_t state_digest(std::span<const NodeId> seeds) const override {
    return digest(seeds, partition_);
  }

  std::vector<NodeId> greedy_candidates(std::span<const NodeId> seeds, bool extended) override {
    sum_settled_subtrees();
    const Timed timed(seconds_.movement);
    const SeedMoveView view{graph_, partition_, sums_, extended};
    std::vector<NodeId> candidates;
    candidates.reserve(seeds.size());
    for (const NodeId s : seeds) candidates.push_back(greedy_candidate(view, s));
    return candidates;
  }

  std::vector<Microstep> macrostep(std::vector<NodeId>& seeds, const MacrostepOptions& options,
                                   const KeepGoing& keep_going) override {
    std::vector<Microstep> microsteps;
    std::vector<RegionId> searched(seeds.size());
    std::iota(searched.begin(), searched.end(), RegionId{0});
    node_score_.assign(graph_.node_count(), never_scored);
    if (options.trails != nullptr) options.trails->assign(seeds.size(), {});
    sum_settled_subtrees();
    score_seeds(seeds, searched);
    for (std::uint64_t visits = 0;; visits = settled_.size()) {
      std::vector<RegionId> moved = move_seeds(seeds, searched, options);
      const auto count = static_cast<std::uint32_t>(moved.size());
      microsteps.push_back({count, visits});
      if (!keep_going(count) || moved.empty()) return microsteps;
      if (options.microstep_skip) searched = std::move(moved);
      search(seeds, searched);
      sum_settled_subtrees();
      score_regions(searched);
      score_seeds(seeds, searched);
    }
  }

  [[nodiscard]] const Partition& current() const override { return partition_; }
  [[nodiscard]] const KernelSeconds& seconds() const override { return seconds_; }

 private:
  void search(std::span<const NodeId> seeds, std::span<const RegionId> searched) {
    const Timed timed(seconds_.locked_search);
    search_locked(graph_, seeds, searched, heap_, partition_.key, settled_);
    derive_parents(graph_, partition_.key, settled_, partition_.parent);
  }

  void sum_settled_subtrees() {
    const Timed timed(seconds_.subtree_sums);
    sum_subtrees(graph_, partition_, settled_, sums_);
  }

  void score_regions(std::span<const RegionId> searched) {
    const Timed timed(seconds_.scoring);
    for (const RegionId r : searched) region_score_[r] = 0;
    add_scores(graph_, partition_.key, settled_, region_score_);
  }

  void score_seeds(std::span<const NodeId> seeds, std::span<const RegionId> searched) {
    for (const RegionId r : searched) node_score_[seeds[r]] = region_score_[r];
  }

  // Regions whose seed moved. A seed that stayed in its unchanged region would stay again, so only
  // the regions just searched are asked.
  std::vector<RegionId> move_seeds(std::vector<NodeId>& seeds, std::span<const RegionId> searched,
                                   const MacrostepOptions& options) {
    const Timed timed(seconds_.movement);
    const SeedMoveView view{graph_, partition_, sums_, options.extended};
    std::vector<RegionId> moved;
    for (const RegionId r : searched) {
      if (options.keeps_seed[r] != 0) continue;
      const NodeId next = precise_candidate(view, node_score_, seeds[r]);
      if (next == no_id) continue;
      seeds[r] = next;
      if (options.trails != nullptr) (*options.trails)[r].push_back(next);
      moved.push_back(r);
    }
    return moved;
  }

  const Graph& graph_;
  IndexedHeap heap_;
  Partition partition_;
  SubtreeSums sums_;
  std::vector<NodeId> settled_;      // by the last search, ascending key
  std::vector<Score> region_score_;  // per region
  std::vector<Score> node_score_;    // per node, since the macrostep began
  KernelSeconds seconds_;
};

}  // namespace

std::unique_ptr<Engine> make_reference_engine(const Graph& graph) {
  return std::make_unique<ReferenceEngine>(graph);
}

}  // namespace geolloyd
