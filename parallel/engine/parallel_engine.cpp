#include "parallel/engine/parallel_engine.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <thread>

#include "core/base/loops.h"
#include "core/base/stopwatch.h"
#include "core/lloyd/seed_move.h"
#include "core/voronoi/fingerprint.h"
#include "parallel/engine/incremental_partition.h"
#include "parallel/engine/region_relaxation.h"

namespace geolloyd {
namespace {

// A callback that throws stops the other threads, too.
void ask(const Engine::KeepGoing& keep_going, std::uint32_t moving, std::atomic<bool>& stopped) {
  try {
    if (!keep_going(moving)) stopped = true;
  } catch (...) {
    stopped = true;
    throw;
  }
}

class ParallelEngine final : public Engine {
 public:
  ParallelEngine(Scheduler& scheduler, const Graph& graph, Frontier frontier)
      : scheduler_(scheduler),
        graph_(graph),
        free_(scheduler, graph, frontier, seconds_),
        local_of_(graph.node_count()) {
    for (std::size_t t = 0; t < scheduler.threads(); ++t) {
      relaxations_.push_back(std::make_unique<RegionRelaxation>(goes_on_));
    }
  }

  void partition(std::span<const NodeId> seeds) override { free_.update(seeds); }

  [[nodiscard]] std::span<const Score> region_scores() const override {
    return free_.totals().score;
  }

  [[nodiscard]] std::uint64_t state_digest(std::span<const NodeId> seeds) const override {
    return digest(seeds, free_.digest_of_nodes());
  }

  std::vector<NodeId> greedy_candidates(std::span<const NodeId> seeds, bool extended) override {
    if (extended_ != extended) free_.forget_sums();
    extended_.reset();  // until all candidates are there
    const std::vector<RegionId> changed = free_.update_sums();
    const Timed timed(seconds_.movement);
    const SeedMoveView view{graph_, free_.partition(), free_.sums(), extended};
    candidates_.resize(seeds.size());
    parallel_for(scheduler_, changed.size(), 64, [&](std::size_t i) {
      candidates_[changed[i]] = greedy_candidate(view, seeds[changed[i]]);
    });
    extended_ = extended;
    return candidates_;
  }

  std::vector<Microstep> macrostep(std::vector<NodeId>& seeds, const MacrostepOptions& options,
                                   const KeepGoing& keep_going) override {
    const Stopwatch watch;
    const bool trusted = free_.forget();  // until all regions are settled
    const std::vector<RegionId> active = active_regions(options);
    std::vector<std::uint32_t> moves(seeds.size(), 0);
    if (options.trails != nullptr) options.trails->assign(seeds.size(), {});
    std::atomic<bool> stopped = false;
    std::atomic<std::uint32_t> moving = static_cast<std::uint32_t>(active.size());
    goes_on_ = [&, caller = std::this_thread::get_id()] {
      if (std::this_thread::get_id() == caller) ask(keep_going, moving, stopped);
      return !stopped.load(std::memory_order_relaxed);
    };
    goes_on_();  // at least once
    const auto settle = [&](RegionId r, Scheduler* shared, RegionRelaxation& relaxation) {
      if (stopped) return;
      moves[r] = settle_region(r, seeds[r], options, shared, relaxation);
      --moving;
    };
    const std::size_t large = count_large(active);
    for (std::size_t i = 0; i < large; ++i) settle(active[i], &scheduler_, *relaxations_.front());
    parallel_for_ranges(scheduler_, active.size() - large, 1,
                        [&](std::size_t i, std::size_t, std::size_t worker) {
                          settle(active[large + i], nullptr, *relaxations_[worker]);
                        });
    if (trusted && !stopped) free_.moved_to(seeds);
    KernelSeconds of_threads;
    for (const auto& relaxation : relaxations_) of_threads += relaxation->take_seconds();
    share_out(watch.seconds(), of_threads, seconds_);
    return microsteps(moves, options.microstep_skip);
  }

  [[nodiscard]] const Partition& current() const override { return free_.partition(); }
  [[nodiscard]] const KernelSeconds& seconds() const override { return seconds_; }

 private:
  // The largest first, so that at the end no thread is left alone with one of those.
  [[nodiscard]] std::vector<RegionId> active_regions(const MacrostepOptions& options) const {
    std::vector<RegionId> active;
    for (RegionId r = 0; r < options.keeps_seed.size(); ++r) {
      if (options.keeps_seed[r] == 0) active.push_back(r);
    }
    std::stable_sort(active.begin(), active.end(), [&](RegionId a, RegionId b) {
      return free_.region_nodes().of(a).size() > free_.region_nodes().of(b).size();
    });
    return active;
  }

  // Of regions, the largest first: how many are more than a thread's fair share of the nodes. These
  // are settled one after the other, each by all threads.
  [[nodiscard]] std::size_t count_large(std::span<const RegionId> active) const {
    constexpr std::size_t least = 1 << 15;  // fewer nodes do not occupy several threads
    std::size_t left = 0;
    for (const RegionId r : active) left += free_.region_nodes().of(r).size();
    std::size_t count = 0;
    for (const RegionId r : active) {
      const std::size_t nodes = free_.region_nodes().of(r).size();
      if (nodes < least || nodes * scheduler_.threads() <= left) break;
      left -= nodes;
      ++count;
    }
    return scheduler_.threads() == 1 ? 0 : count;
  }

  // Moves `seed` to where it rests and returns in how many moves.
  std::uint32_t settle_region(RegionId r, NodeId& seed, const MacrostepOptions& options,
                              Scheduler* shared, RegionRelaxation& relaxation) {
    relaxation.gather(graph_, free_.partition().key, free_.region_nodes().of(r), local_of_, shared);
    const auto [rest, moves] =
        relaxation.relax(seed, free_.totals().score[r], options.extended,
                         options.trails != nullptr ? &(*options.trails)[r] : nullptr);
    if (rest != seed) relaxation.scatter_keys(r, free_.keys());
    seed = rest;
    return moves;
  }

  // What the definition's microsteps would have been, were they made one by one.
  [[nodiscard]] std::vector<Microstep> microsteps(std::span<const std::uint32_t> moves,
                                                  bool skip) const {
    std::uint32_t most = 0;
    for (const std::uint32_t m : moves) most = std::max(most, m);
    std::vector<Microstep> result(most + 1);
    for (RegionId r = 0; r < moves.size(); ++r) {
      for (std::uint32_t i = 0; i < moves[r]; ++i) ++result[i].seeds_moved;
      for (std::uint32_t i = 0; i < (skip ? moves[r] : most); ++i) {
        result[i + 1].node_visits += free_.region_nodes().of(r).size();
      }
    }
    return result;
  }

  Scheduler& scheduler_;
  const Graph& graph_;
  KernelSeconds seconds_;
  IncrementalPartition free_;
  std::vector<NodeId> candidates_;  // per region; of the last update of the sums
  std::optional<bool> extended_;    // their heuristic
  std::vector<NodeId> local_of_;    // per node, its number within its region
  std::function<bool()> goes_on_;   // of the macrostep
  std::vector<std::unique_ptr<RegionRelaxation>> relaxations_;  // per thread
};

}  // namespace

std::unique_ptr<Engine> make_parallel_engine(Scheduler& scheduler, const Graph& graph,
                                             Frontier frontier) {
  return std::make_unique<ParallelEngine>(scheduler, graph, frontier);
}

}  // namespace geolloyd
