#include "core/lloyd/relaxation.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/lloyd/improvement.h"
#include "core/voronoi/energy.h"
#include "core/voronoi/fingerprint.h"

namespace geolloyd {
namespace {

// Above any there can be where there are none.
Score lowest_score(const std::vector<Step>& steps) {
  Score lowest = ~Score{0};
  for (const Step& step : steps) lowest = std::min(lowest, step.score);
  return lowest;
}

bool has_converged(const std::vector<Step>& steps) {
  if (steps.empty()) return false;
  const Step& last = steps.back();
  return last.phase == Phase::improvement ||
         (last.phase == Phase::precise && last.seeds_moved == 0);
}

class LloydLoop {
 public:
  LloydLoop(const Graph& graph, Engine& engine, RelaxationState& state,
            const RelaxationOptions& options, const ProgressCallback& observer,
            SeedTrails* trails = nullptr, StepStartCallback beginning = {})
      : graph_(graph),
        engine_(engine),
        state_(state),
        options_(options),
        observer_(observer),
        trails_(trails),
        beginning_(std::move(beginning)) {
    if (trails != nullptr) trails->clear();
  }

  Relaxation run(const StepCallback& boundary) {
    std::optional<StopReason> end;
    while (!(end = take_step())) {
      if (boundary) boundary(state_);
    }
    return finish(*end);
  }

  // Returns why there is no next step, or none to its end.
  std::optional<StopReason> take_step() {
    const Phase phase = next_phase(state_, options_);
    if (phase == Phase::improvement && is_improved_enough()) return StopReason::converged;
    if (phase == Phase::precise && next_number(phase) > options_.max_macrosteps)
      return StopReason::limit;
    if (phase != Phase::improvement && wanders()) return StopReason::recurred;
    const Stopwatch watch;
    const KernelSeconds before = engine_.seconds();
    begin_step(phase);
    if (phase == Phase::precise && has_macrostep_from(next_.step.state))
      return StopReason::recurred;
    announce_step();
    is_cut_short_ = !take(phase);
    is_partitioned_ = !is_cut_short_ && next_.step.seeds_moved == 0 && phase != Phase::improvement;
    next_.step.seconds = since(before, engine_.seconds(), watch.seconds());
    if (is_cut_short_) return StopReason::interrupted;
    accept_step();
    return std::nullopt;
  }

 private:
  // A step, and what it makes of the state if it is taken to its end.
  struct Attempt {
    Step step;
    std::vector<NodeId> seeds;
    std::vector<Score> scores;  // per region at its start, precise phase only
  };

  [[nodiscard]] bool is_improved_enough() const {
    std::uint32_t rounds = 0;
    double seconds = 0;
    for (const Step& step : state_.steps) {
      if (step.phase != Phase::improvement) continue;
      ++rounds;
      seconds += total(step.seconds);
    }
    return rounds >= options_.improvement_rounds || seconds >= options_.improvement_seconds;
  }

  // Each macrostep lowers the score or keeps it. Where it keeps it, as where all masses are 0, the
  // seeds may wander from one equally good state to the next, more of them than can be met.
  [[nodiscard]] bool wanders() const {
    constexpr std::size_t most_in_vain = 100;
    const std::vector<Step>& steps = state_.steps;
    if (steps.size() <= most_in_vain) return false;
    const Step& earlier = steps[steps.size() - 1 - most_in_vain];
    return earlier.phase == Phase::precise && steps.back().score >= earlier.score;
  }

  // Counts from 1.
  [[nodiscard]] std::uint32_t next_number(Phase phase) const {
    return 1 + static_cast<std::uint32_t>(
                   std::count_if(state_.steps.begin(), state_.steps.end(),
                                 [phase](const Step& step) { return step.phase == phase; }));
  }

  [[nodiscard]] bool has_macrostep_from(std::uint64_t state) const {
    return std::any_of(state_.steps.begin(), state_.steps.end(), [state](const Step& step) {
      return step.phase == Phase::precise && step.state == state;
    });
  }

  void begin_step(Phase phase) {
    engine_.partition(state_.seeds);
    is_partitioned_ = true;
    next_.seeds = state_.seeds;
    next_.scores.clear();
    next_.step = {};
    next_.step.phase = phase;
    next_.step.node_visits = graph_.node_count();
    next_.step.score = total_score();
    next_.step.energy = to_energy(graph_, next_.step.score);
    next_.step.state = engine_.state_digest(state_.seeds);
    if (next_.step.score < lowest_score(state_.steps)) state_.best_seeds = state_.seeds;
  }

  void announce_step() const {
    if (!beginning_) return;
    const Phase phase = next_.step.phase;
    beginning_({phase, next_number(phase), state_.steps.size(), next_.step.energy, state_.seeds,
                engine_.current()});
  }

  bool greedy_step() {
    move_greedily(engine_.greedy_candidates(state_.seeds, extended()));
    return notify(
        {Phase::greedy, next_number(Phase::greedy), next_.step.seeds_moved, next_.step.energy});
  }

  void move_greedily(const std::vector<NodeId>& candidates) {
    std::vector<bool>& has_been_seed = state_.has_been_seed;
    has_been_seed.resize(graph_.node_count(), false);
    for (const NodeId s : state_.seeds) has_been_seed[s] = true;
    for (std::size_t r = 0; r < candidates.size(); ++r) {
      if (candidates[r] == no_id || has_been_seed[candidates[r]]) continue;
      next_.seeds[r] = candidates[r];
      ++next_.step.seeds_moved;
    }
  }

  bool take(Phase phase) {
    switch (phase) {
      case Phase::greedy:
        return greedy_step();
      case Phase::precise:
        next_.scores = state_.last_scores;
        return macrostep() && count_moves();
      case Phase::improvement:
        return improve() && count_moves();
    }
    return false;
  }

  bool count_moves() {
    for (std::size_t r = 0; r < next_.seeds.size(); ++r) {
      if (next_.seeds[r] != state_.seeds[r]) ++next_.step.seeds_moved;
    }
    return true;
  }

  // One macrostep of the seeds just partitioned. Regions with the score that they had at the last
  // one keep their seed.
  bool macrostep() {
    const std::span<const Score> scores = engine_.region_scores();
    const std::size_t regions = scores.size();
    std::vector<std::uint8_t> keeps_seed(regions, 0);
    if (options_.macrostep_skip && !next_.scores.empty()) {
      for (std::size_t r = 0; r < regions; ++r) {
        keeps_seed[r] = scores[r] == next_.scores[r] ? 1 : 0;
      }
    }
    next_.scores.assign(scores.begin(), scores.end());
    bool goes_on = true;
    const Phase phase = next_.step.phase;
    const std::uint32_t number = next_number(phase);
    const std::vector<Microstep> microsteps = engine_.macrostep(
        next_.seeds,
        {keeps_seed, extended(), options_.microstep_skip,
         phase == Phase::precise ? trails_ : nullptr},
        [&](std::uint32_t seeds_moving) {
          goes_on = goes_on && notify({phase, number, seeds_moving, next_.step.energy});
          return goes_on;
        });
    for (const Microstep& microstep : microsteps) {
      next_.step.node_visits += microstep.node_visits;
      next_.step.microsteps.push_back(microstep);
    }
    return goes_on;
  }

  // One round: perturbs the seeds, relaxes them, and keeps what costs less than before.
  bool improve() {
    const ScoredPartition base = partitioned(state_.seeds);
    next_.scores = state_.last_scores;
    next_.seeds = perturb(graph_, base, next_number(Phase::improvement));
    if (!relax_perturbed()) return false;
    const std::vector<std::uint8_t> is_lower = lower_clusters(base, partitioned(next_.seeds));
    for (std::size_t r = 0; r < is_lower.size(); ++r) {
      if (is_lower[r] != 0) continue;
      next_.seeds[r] = base.seeds[r];
      next_.scores[r] = state_.last_scores[r];
    }
    return true;
  }

  // What has not come to rest after some macrosteps goes on in the next round, if it is kept.
  bool relax_perturbed() {
    constexpr int most_macrosteps = 5;
    std::vector<NodeId> before;
    for (int i = 0; i < most_macrosteps && next_.seeds != before; ++i) {
      engine_.partition(next_.seeds);
      before = next_.seeds;
      if (!macrostep()) return false;
    }
    engine_.partition(next_.seeds);
    return true;
  }

  [[nodiscard]] ScoredPartition partitioned(const std::vector<NodeId>& seeds) const {
    const std::span<const Score> scores = engine_.region_scores();
    return {seeds, engine_.current().key, {scores.begin(), scores.end()}};
  }

  void accept_step() {
    if (next_.step.phase != Phase::greedy) state_.has_been_seed.clear();
    state_.seeds.swap(next_.seeds);
    state_.last_scores.swap(next_.scores);
    state_.steps.push_back(std::move(next_.step));
  }

  Relaxation finish(StopReason end) {
    Relaxation result;
    result.stop_reason = end;
    result.steps = state_.steps;
    result.seeds = state_.seeds;
    if (is_cut_short_) {
      result.steps.push_back(next_.step);
      result.seeds = next_.seeds;
    }
    if (!is_partitioned_) engine_.partition(result.seeds);
    if (result.seeds != state_.best_seeds && lowest_score(result.steps) <= total_score()) {
      result.seeds = state_.best_seeds;
      engine_.partition(result.seeds);
    }
    result.partition = engine_.current();
    result.region_score.assign(engine_.region_scores().begin(), engine_.region_scores().end());
    result.energy = to_energy(graph_, total_score());
    for (const Step& step : result.steps) {
      result.fingerprint = chain(result.fingerprint, step.state);
    }
    result.fingerprint = chain(result.fingerprint, engine_.state_digest(result.seeds));
    return result;
  }

  [[nodiscard]] Score total_score() const {
    const std::span<const Score> scores = engine_.region_scores();
    return std::accumulate(scores.begin(), scores.end(), Score{0});
  }

  [[nodiscard]] bool extended() const { return options_.greedy != GreedyMode::standard; }

  bool notify(const Progress& progress) { return !observer_ || observer_(progress); }

  const Graph& graph_;
  Engine& engine_;
  RelaxationState& state_;
  const RelaxationOptions& options_;
  const ProgressCallback& observer_;
  SeedTrails* trails_;
  StepStartCallback beginning_;
  bool is_partitioned_ = false;  // the engine holds the partition of the seeds as they are
  Attempt next_;
  bool is_cut_short_ = false;
};

}  // namespace

// The greedy phase ends with the first step in which no seed moves; a seed moves to no node twice,
// so one comes.
Phase next_phase(const RelaxationState& state, const RelaxationOptions& options) {
  const std::vector<Step>& steps = state.steps;
  const bool is_over =
      !steps.empty() && (steps.back().phase != Phase::greedy || steps.back().seeds_moved == 0);
  if (has_converged(steps)) return Phase::improvement;
  const bool is_greedy =
      options.greedy != GreedyMode::off && !is_over && steps.size() < options.max_greedy_steps;
  return is_greedy ? Phase::greedy : Phase::precise;
}

std::optional<StopReason> take_step(const Graph& graph, Engine& engine, RelaxationState& state,
                                    const RelaxationOptions& options,
                                    const ProgressCallback& observer, SeedTrails* trails) {
  return LloydLoop(graph, engine, state, options, observer, trails).take_step();
}

Relaxation relax(const Graph& graph, Engine& engine, RelaxationState& state,
                 const RelaxationOptions& options, const ProgressCallback& observer,
                 const StepCallback& boundary, const StepStartCallback& beginning) {
  return LloydLoop(graph, engine, state, options, observer, nullptr, beginning).run(boundary);
}

Relaxation relax(const Graph& graph, Engine& engine, std::vector<NodeId> seeds,
                 const RelaxationOptions& options, const ProgressCallback& observer) {
  RelaxationState state;
  state.seeds = std::move(seeds);
  return relax(graph, engine, state, options, observer);
}

}  // namespace geolloyd
