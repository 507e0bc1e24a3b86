#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "core/graph/graph.h"
#include "core/lloyd/engine.h"
#include "core/voronoi/partition.h"
#include "geolloyd/choices.h"

namespace geolloyd {

/// Options of the relaxation, with the thesis's settings. Where it is known how the first seeds
/// were chosen, suggested_greedy_mode() names a better `greedy`.
struct RelaxationOptions {
  static constexpr std::uint32_t no_limit = std::numeric_limits<std::uint32_t>::max();

  GreedyMode greedy = GreedyMode::extended;
  bool microstep_skip = true;  ///< changes no result
  bool macrostep_skip = true;  ///< part of the definition: may, in theory, change the result
  std::uint32_t max_greedy_steps = no_limit;
  std::uint32_t max_macrosteps = no_limit;
  /// Rounds of improvement after the precise phase has converged; the last one is that in which
  /// one of both limits is reached. A limit of seconds depends on the machine, so the result does.
  std::uint32_t improvement_rounds = 0;
  double improvement_seconds = std::numeric_limits<double>::infinity();
};

/// One greedy step, one macrostep of the precise phase, or one round of improvement.
struct Step {
  Phase phase = Phase::greedy;
  std::uint32_t seeds_moved = 0;      ///< seeds that end the step elsewhere than they began it
  std::uint64_t node_visits = 0;      ///< nodes settled by all its searches
  Score score = 0;                    ///< of the partition at its start, ticks
  double energy = 0;                  ///< the same in mesh units
  std::uint64_t state = 0;            ///< digest of the partition at its start
  std::vector<Microstep> microsteps;  ///< of its macrosteps: of one, or of all in a round
  KernelSeconds seconds;
};

/// A relaxation between two steps: all that the rest of its course depends on, whatever engine
/// takes it from there.
struct RelaxationState {
  std::vector<NodeId> seeds;        ///< with which the next step begins
  std::vector<NodeId> best_seeds;   ///< those of the lowest score met so far, the earliest of them
  std::vector<bool> has_been_seed;  ///< per node, in the greedy phase; else empty
  std::vector<Score> last_scores;   ///< per region at the start of its last macrostep, if any
  std::vector<Step> steps;          ///< taken so far
};

/// The result of a relaxation: the state of lowest score met, the earliest of equals. The states
/// met are those at the start of each step, and the last one.
struct Relaxation {
  std::vector<NodeId> seeds;
  Partition partition;  ///< of `seeds`, regions free
  std::vector<Score> region_score;
  double energy = 0;  ///< sum of mass * distance^2, mesh units
  StopReason stop_reason = StopReason::converged;
  std::vector<Step> steps;
  /// FeatureCurves the digests of the states at the start of each step, in their order, and at last
  /// that of the result, even where the result is one of them.
  std::uint64_t fingerprint = 0;
};

/// A step that is about to be taken.
struct StepStart {
  Phase phase = Phase::greedy;
  std::uint32_t number = 0;  ///< counts from 1 in each phase
  std::size_t steps_before = 0;
  double energy = 0;  ///< mesh units
  const std::vector<NodeId>& seeds;
  const Partition& partition;  ///< of the seeds, regions free
};

/// Called as each step begins, those that are cut short too.
using StepStartCallback = std::function<void(const StepStart&)>;

/// Called after each step that was taken to its end.
using StepCallback = std::function<void(const RelaxationState&)>;

/// Moves `seeds` toward the centroids of their regions until none moves: greedy phase, then precise
/// phase (design: canonical definition; thesis, relaxation). `engine` works on `graph`. The result
/// is the best state met, also where the relaxation converges: the greedy phase may raise the
/// score. Where no seed moves, the score is a local minimum. Rounds of improvement leave it: each
/// perturbs the seeds (improvement.h), takes up to five macrosteps, and keeps the clusters of
/// regions that cost less than before. So no round raises the score.
Relaxation relax(const Graph& graph, Engine& engine, std::vector<NodeId> seeds,
                 const RelaxationOptions& options, const ProgressCallback& observer = {});

/// The same from any state of it, with the same seeds at first and the same options: course, result
/// and fingerprint are those of a relaxation never left. Limits may be others; a precise phase that
/// has begun stays. `state`, at first no more than seeds, becomes that after the last whole step.
Relaxation relax(const Graph& graph, Engine& engine, RelaxationState& state,
                 const RelaxationOptions& options, const ProgressCallback& observer = {},
                 const StepCallback& boundary = {}, const StepStartCallback& beginning = {});

/// The phase that the next step belongs to, if there is one.
Phase next_phase(const RelaxationState& state, const RelaxationOptions& options);

/// Takes the next step to its end: relax() takes all there are. Returns why there is none, or why
/// it was not taken to its end, and then leaves the seeds and steps of `state`; a relax() from that
/// state gives the result. `trails`, if not null, become those of a macrostep of the precise phase,
/// and of any other step nothing.
std::optional<StopReason> take_step(const Graph& graph, Engine& engine, RelaxationState& state,
                                    const RelaxationOptions& options,
                                    const ProgressCallback& observer = {},
                                    SeedTrails* trails = nullptr);

}  // namespace geolloyd
