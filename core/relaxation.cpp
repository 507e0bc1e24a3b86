#include "core/relaxation.h"

#include <algorithm>
#include <numeric>
#include <unordered_set>
#include <utility>

#include "core/energy.h"
#include "core/fingerprint.h"
#include "core/stopwatch.h"

namespace geolloyd {
namespace {

class LloydLoop {
 public:
  LloydLoop(const Graph& graph, Engine& engine, std::vector<NodeId> seeds,
            const RelaxationOptions& options, const Observer& observer)
      : graph_(graph), engine_(engine), options_(options), observer_(observer) {
    result_.seeds = std::move(seeds);
  }

  Relaxation run() {
    if (options_.greedy != GreedyMode::off) greedy_phase();
    if (result_.end != End::interrupted) precise_phase();
    finish();
    return std::move(result_);
  }

 private:
  // Ends with the first step in which no seed moves; a seed moves to no node twice, so one comes.
  void greedy_phase() {
    std::vector<bool> has_been_seed(graph_.node_count(), false);
    for (std::uint32_t step = 1; step <= options_.max_greedy_steps; ++step) {
      const bool goes_on = run_step(Phase::greedy, [&](Step& record) {
        const std::vector<NodeId> candidates = engine_.greedy_candidates(result_.seeds, extended());
        record.seeds_moved = move_greedily(candidates, has_been_seed);
        return notify({Phase::greedy, step, record.seeds_moved, record.energy});
      });
      if (!goes_on || result_.steps.back().seeds_moved == 0) return;
    }
  }

  std::uint32_t move_greedily(const std::vector<NodeId>& candidates,
                              std::vector<bool>& has_been_seed) {
    for (const NodeId s : result_.seeds) has_been_seed[s] = true;
    std::uint32_t moved = 0;
    for (std::size_t r = 0; r < candidates.size(); ++r) {
      if (candidates[r] == no_id || has_been_seed[candidates[r]]) continue;
      result_.seeds[r] = candidates[r];
      ++moved;
    }
    return moved;
  }

  // Each macrostep lowers the score or keeps it. Where it keeps it, as where all masses are 0, the
  // seeds may wander from one equally good state to the next, more of them than can be met.
  void precise_phase() {
    constexpr std::uint32_t most_in_vain = 100;
    std::unordered_set<std::uint64_t> met;
    std::vector<Score> last_scores;
    Score lowest = never_scored;
    std::uint32_t in_vain = 0;
    for (std::uint32_t step = 1; step <= options_.max_macrosteps; ++step) {
      if (!met.insert(digest(result_.seeds)).second) {
        result_.end = End::recurred;
        return;
      }
      const bool goes_on = run_step(
          Phase::precise, [&](Step& record) { return macrostep(step, record, last_scores); });
      if (!goes_on) return;
      if (result_.steps.back().seeds_moved == 0) return;
      in_vain = result_.steps.back().score < lowest ? 0 : in_vain + 1;
      lowest = std::min(lowest, result_.steps.back().score);
      if (in_vain == most_in_vain) {
        result_.end = End::recurred;
        return;
      }
    }
    result_.end = End::limit;
  }

  bool macrostep(std::uint32_t step, Step& record, std::vector<Score>& last_scores) {
    const std::span<const Score> scores = engine_.region_scores();
    const std::size_t regions = scores.size();
    std::vector<std::uint8_t> keeps_seed(regions, 0);
    if (options_.macrostep_skip && !last_scores.empty()) {
      for (std::size_t r = 0; r < regions; ++r) keeps_seed[r] = scores[r] == last_scores[r] ? 1 : 0;
    }
    last_scores.assign(scores.begin(), scores.end());

    const std::vector<NodeId> before = result_.seeds;
    bool goes_on = true;
    record.microsteps = engine_.macrostep(
        result_.seeds, {keeps_seed, extended(), options_.microstep_skip},
        [&](std::uint32_t seeds_moving) {
          goes_on = goes_on && notify({Phase::precise, step, seeds_moving, record.energy});
          return goes_on;
        });
    for (const Microstep& microstep : record.microsteps) {
      record.node_visits += microstep.node_visits;
    }
    for (std::size_t r = 0; r < regions; ++r) {
      if (result_.seeds[r] != before[r]) ++record.seeds_moved;
    }
    return goes_on;
  }

  // Partition, record, then what the phase does with it.
  template <class Body>
  bool run_step(Phase phase, Body&& body) {
    const Stopwatch watch;
    const KernelSeconds before = engine_.seconds();
    Step record;
    record.phase = phase;
    engine_.partition(result_.seeds);
    record.node_visits = graph_.node_count();
    record.score = total_score();
    record.energy = to_energy(graph_, record.score);
    record.state = engine_.state_digest(result_.seeds);
    if (best_seeds_.empty() || record.score < best_score_) {
      best_score_ = record.score;
      best_seeds_ = result_.seeds;
    }
    const bool goes_on = body(record);
    record.seconds = since(before, engine_.seconds(), watch.seconds());
    result_.steps.push_back(std::move(record));
    if (!goes_on) result_.end = End::interrupted;
    return goes_on;
  }

  void finish() {
    if (result_.end != End::converged || result_.steps.empty()) {
      engine_.partition(result_.seeds);
      if (!best_seeds_.empty() && best_score_ < total_score()) {
        result_.seeds = best_seeds_;
        engine_.partition(result_.seeds);
      }
    }
    result_.partition = engine_.current();
    result_.region_score.assign(engine_.region_scores().begin(), engine_.region_scores().end());
    result_.energy = to_energy(graph_, total_score());
    for (const Step& step : result_.steps) {
      result_.fingerprint = chain(result_.fingerprint, step.state);
    }
    result_.fingerprint = chain(result_.fingerprint, engine_.state_digest(result_.seeds));
  }

  [[nodiscard]] Score total_score() const {
    const std::span<const Score> scores = engine_.region_scores();
    return std::accumulate(scores.begin(), scores.end(), Score{0});
  }

  [[nodiscard]] bool extended() const { return options_.greedy != GreedyMode::standard; }

  bool notify(const Progress& progress) { return !observer_ || observer_(progress); }

  const Graph& graph_;
  Engine& engine_;
  const RelaxationOptions& options_;
  const Observer& observer_;
  Relaxation result_;
  Score best_score_ = 0;
  std::vector<NodeId> best_seeds_;
};

}  // namespace

Relaxation relax(const Graph& graph, Engine& engine, std::vector<NodeId> seeds,
                 const RelaxationOptions& options, const Observer& observer) {
  return LloydLoop(graph, engine, std::move(seeds), options, observer).run();
}

}  // namespace geolloyd
