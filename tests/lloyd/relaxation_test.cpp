#include "core/lloyd/relaxation.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <string>

#include "core/graph/mesh_graph.h"
#include "core/lloyd/reference_engine.h"
#include "core/seeds/seeds.h"
#include "core/shapes/shapes.h"
#include "core/voronoi/check_partition.h"
#include "core/voronoi/energy.h"
#include "core/voronoi/fingerprint.h"
#include "tests/support/naive.h"
#include "tests/support/random_graph.h"
#include "tests/support/same_relaxation.h"

namespace geolloyd {
namespace {

constexpr std::array all_modes = {GreedyMode::off, GreedyMode::standard, GreedyMode::extended};

Relaxation run(const Graph& graph, const std::vector<NodeId>& seeds,
               const RelaxationOptions& options = {}, const ProgressCallback& observer = {}) {
  const auto engine = make_reference_engine(graph);
  return relax(graph, *engine, seeds, options, observer);
}

template <class Check>
void for_random_cases(Check&& check) {
  for (std::uint64_t random_seed = 0; random_seed < 60; ++random_seed) {
    SCOPED_TRACE(random_seed);
    const NodeId nodes = 5 + random_number(random_seed, 1000, 35);
    const auto seeds = 1 + random_number(random_seed, 1001, nodes / 3 + 1);
    const Graph graph = random_seed % 3 == 0 ? grid_graph(5, 2 + nodes / 5)
                                             : random_connected_graph(random_seed, nodes);
    check(graph, random_nodes(random_seed, static_cast<NodeId>(graph.node_count()), seeds));
  }
}

template <class Check>
void for_random_cases_in_all_modes(Check&& check) {
  for (const GreedyMode mode : all_modes) {
    for (const bool macrostep_skip : {true, false}) {
      RelaxationOptions options;
      options.greedy = mode;
      options.macrostep_skip = macrostep_skip;
      for_random_cases([&](const Graph& graph, const std::vector<NodeId>& seeds) {
        check(graph, seeds, options);
      });
    }
  }
}

std::size_t steps_in(const Relaxation& result, Phase phase) {
  std::size_t count = 0;
  for (const Step& step : result.steps) count += step.phase == phase ? 1 : 0;
  return count;
}

// The whole definition against a second, independent writing of it.
TEST(Relaxation, AgreesWithBruteForceStepByStep) {
  for_random_cases_in_all_modes([](const Graph& graph, const std::vector<NodeId>& seeds,
                                   const RelaxationOptions& options) {
    const Relaxation result = run(graph, seeds, options);
    const naive::History expected = naive::relax(graph, seeds, options);
    ASSERT_EQ(result.stop_reason, expected.recurred ? StopReason::recurred : StopReason::converged);
    ASSERT_EQ(steps_in(result, Phase::greedy), expected.greedy.size());
    ASSERT_EQ(steps_in(result, Phase::precise), expected.macro.size());
    ASSERT_EQ(result.seeds, naive::best_state(graph, expected));
    for (std::size_t i = 0; i < result.steps.size(); ++i) {
      const Step& step = result.steps[i];
      const bool greedy = i < expected.greedy.size();
      const std::size_t macro = i - expected.greedy.size();
      const auto& at_start = greedy ? expected.greedy[i] : expected.macro[macro];
      const Partition p = naive::partition(graph, at_start);
      Score score = 0;
      for (RegionId r = 0; r < seeds.size(); ++r) score += naive::score(graph, p, r);
      ASSERT_EQ(step.score, score) << i;
      ASSERT_EQ(step.state, digest(at_start, p)) << i;  // seeds, regions, distances, parents
      if (!greedy) {
        ASSERT_EQ(step.microsteps.size(), expected.microsteps[macro]);
      }
    }
  });
}

TEST(Relaxation, EndsWithACertifiedPartitionOfItsSeeds) {
  for_random_cases([](const Graph& graph, const std::vector<NodeId>& seeds) {
    const Relaxation result = run(graph, seeds);
    const auto defect = check_partition(graph, result.seeds, result.partition, Regions::free);
    ASSERT_FALSE(defect.has_value()) << defect->what;
    const Score total =
        std::accumulate(result.region_score.begin(), result.region_score.end(), Score{0});
    ASSERT_EQ(to_energy(graph, total), result.energy);
  });
}

TEST(Relaxation, SkippingMicrostepsChangesNothingButTheVisits) {
  for_random_cases_in_all_modes(
      [](const Graph& graph, const std::vector<NodeId>& seeds, RelaxationOptions options) {
        const Relaxation skipping = run(graph, seeds, options);
        options.microstep_skip = false;
        const Relaxation searching = run(graph, seeds, options);
        ASSERT_EQ(skipping.fingerprint, searching.fingerprint);
        ASSERT_EQ(skipping.seeds, searching.seeds);
        ASSERT_EQ(skipping.steps.size(), searching.steps.size());
        for (std::size_t i = 0; i < skipping.steps.size(); ++i) {
          ASSERT_EQ(skipping.steps[i].microsteps.size(), searching.steps[i].microsteps.size());
          ASSERT_LE(skipping.steps[i].node_visits, searching.steps[i].node_visits);
        }
      });
}

TEST(Relaxation, NeverRaisesTheEnergyAcrossMacrosteps) {
  for_random_cases_in_all_modes(
      [](const Graph& graph, const std::vector<NodeId>& seeds, const RelaxationOptions& options) {
        const Relaxation result = run(graph, seeds, options);
        const Step* before = nullptr;
        for (const Step& step : result.steps) {
          if (step.phase != Phase::precise) continue;
          if (before != nullptr) {
            ASSERT_LE(step.score, before->score);
          }
          before = &step;
        }
      });
}

// No seed of the state in which a relaxation converges can be bettered inside its region by one
// arc.
TEST(Relaxation, ConvergesToLocalCentroids) {
  RelaxationOptions options;
  options.macrostep_skip = false;
  for_random_cases([&](const Graph& graph, const std::vector<NodeId>& seeds) {
    RelaxationState state;
    state.seeds = seeds;
    const auto engine = make_reference_engine(graph);
    if (relax(graph, *engine, state, options).stop_reason != StopReason::converged) return;
    const Partition last = naive::partition(graph, state.seeds);
    const std::vector<RegionId> regions = naive::regions_of(last);
    for (RegionId r = 0; r < state.seeds.size(); ++r) {
      for (const NodeId v : naive::neighbours_in_region(graph, last, state.seeds[r])) {
        std::vector<NodeId> moved = state.seeds;
        moved[r] = v;
        const Partition p = naive::partition(graph, moved, regions);
        ASSERT_GE(naive::score(graph, p, r), naive::score(graph, last, r));
      }
    }
  });
}

TEST(Relaxation, FindsTheMiddleOfARowAndTheQuartersOfTwo) {
  const Graph row = grid_graph(1, 101);
  EXPECT_EQ(run(row, {3}).seeds, std::vector<NodeId>{50});
  std::vector<NodeId> two = run(grid_graph(1, 100), {0, 1}).seeds;
  EXPECT_NEAR(two[0], 25, 1);
  EXPECT_NEAR(two[1], 75, 1);
}

TEST(Relaxation, StandsOneNodeAllNodesSeedsAndIsolatedNodes) {
  EXPECT_EQ(run(grid_graph(1, 1), {0}).seeds, std::vector<NodeId>{0});
  const Relaxation all = run(grid_graph(2, 2), {3, 1, 0, 2});
  EXPECT_EQ(all.seeds, (std::vector<NodeId>{3, 1, 0, 2}));
  EXPECT_EQ(all.energy, 0);
  EXPECT_EQ(all.stop_reason, StopReason::converged);
  const Graph apart = make_graph({}, std::vector<double>(3, 1.0));
  EXPECT_EQ(run(apart, {2, 0, 1}).stop_reason, StopReason::converged);
}

TEST(Relaxation, TracesWhatItDid) {
  const Graph graph = grid_graph(30, 30);
  const Relaxation result = run(graph, {0, 1, 2, 3});
  ASSERT_FALSE(result.steps.empty());
  EXPECT_EQ(result.steps.front().phase, Phase::greedy);
  EXPECT_EQ(result.steps.front().node_visits, 900U);
  EXPECT_EQ(result.steps.back().phase, Phase::precise);
  EXPECT_EQ(result.steps.back().seeds_moved, 0U);
  EXPECT_EQ(result.steps.back().energy, result.energy);
  EXPECT_GT(result.steps.front().energy, result.energy);
  EXPECT_EQ(result.steps.back().microsteps.front().node_visits, 0U);
  EXPECT_EQ(result.steps.back().microsteps.back().seeds_moved, 0U);
  EXPECT_GT(result.steps.front().seconds.free_search, 0);
}

TEST(Relaxation, FingerprintDependsOnEverythingThatHappened) {
  const Graph graph = grid_graph(20, 20);
  const std::uint64_t fingerprint = run(graph, {0, 1, 2}).fingerprint;
  EXPECT_EQ(run(graph, {0, 1, 2}).fingerprint, fingerprint);
  EXPECT_NE(run(graph, {1, 0, 2}).fingerprint, fingerprint);
  EXPECT_NE(run(graph, {0, 1, 3}).fingerprint, fingerprint);
  RelaxationOptions options;
  options.greedy = GreedyMode::off;
  EXPECT_NE(run(graph, {0, 1, 2}, options).fingerprint, fingerprint);
}

TEST(Relaxation, StopsWhenToldWithTheBestStateSoFar) {
  const Graph graph = grid_graph(30, 30);
  const std::vector<NodeId> seeds = {0, 1, 2, 3, 4, 5};
  const Relaxation whole = run(graph, seeds);
  for (int calls : {1, 5, 20, 30, 60}) {
    int left = calls;
    const Relaxation part = run(graph, seeds, {}, [&](const Progress&) { return --left > 0; });
    ASSERT_EQ(part.stop_reason, StopReason::interrupted) << calls;
    EXPECT_FALSE(check_partition(graph, part.seeds, part.partition, Regions::free).has_value());
    for (const Step& step : part.steps) EXPECT_LE(part.energy, step.energy);
    EXPECT_EQ(run(graph, part.seeds).stop_reason, StopReason::converged);
  }
  EXPECT_EQ(whole.stop_reason, StopReason::converged);
}

Relaxation resume(const Graph& graph, RelaxationState state, const RelaxationOptions& options) {
  const auto engine = make_reference_engine(graph);
  return relax(graph, *engine, state, options);
}

TEST(Relaxation, GoesOnFromAnyBoundaryAsIfNeverLeft) {
  for_random_cases_in_all_modes([](const Graph& graph, const std::vector<NodeId>& seeds,
                                   RelaxationOptions options) {
    for (const std::uint32_t limit : {1U, 3U, RelaxationOptions::no_limit}) {
      options.max_greedy_steps = options.max_macrosteps = limit;
      RelaxationState state;
      state.seeds = seeds;
      std::vector<RelaxationState> boundaries = {state};
      const auto engine = make_reference_engine(graph);
      const Relaxation whole = relax(graph, *engine, state, options, {},
                                     [&](const RelaxationState& s) { boundaries.push_back(s); });
      expect_same(whole, run(graph, seeds, options));
      ASSERT_EQ(boundaries.size(), whole.steps.size() + 1);
      for (const RelaxationState& boundary : boundaries) {
        expect_same(whole, resume(graph, boundary, options));
      }
    }
  });
}

TEST(Relaxation, GoesOnFromTheLastBoundaryBeforeAnInterrupt) {
  const Graph graph = grid_graph(12, 12);
  const std::vector<NodeId> seeds = {0, 1, 2, 3, 4, 5};
  for (const GreedyMode mode : all_modes) {
    RelaxationOptions options;
    options.greedy = mode;
    const Relaxation whole = run(graph, seeds, options);
    int calls = 0;
    run(graph, seeds, options, [&](const Progress&) { return ++calls > 0; });
    for (int last = 1; last <= calls; ++last) {
      RelaxationState state;
      state.seeds = seeds;
      const auto engine = make_reference_engine(graph);
      int left = last;
      const Relaxation part =
          relax(graph, *engine, state, options, [&](const Progress&) { return --left > 0; });
      ASSERT_EQ(part.stop_reason, StopReason::interrupted);
      ASSERT_EQ(part.steps.size(), state.steps.size() + 1);
      expect_same(whole, resume(graph, state, options));
    }
  }
}

TEST(Relaxation, GoesBeyondALimitItWasStoppedAt) {
  const Graph graph = grid_graph(30, 30);
  RelaxationOptions options;
  RelaxationState state;
  state.seeds = {0, 1, 2, 3};
  const Relaxation whole = run(graph, state.seeds, options);
  const auto engine = make_reference_engine(graph);
  for (options.max_macrosteps = 1; options.max_macrosteps < 100; ++options.max_macrosteps) {
    const Relaxation part = relax(graph, *engine, state, options);
    ASSERT_EQ(steps_in(part, Phase::precise), state.steps.size() - steps_in(part, Phase::greedy));
    if (part.stop_reason == StopReason::limit) continue;
    expect_same(whole, part);
    return;
  }
  FAIL() << "no end in 100 macrosteps";
}

TEST(Relaxation, KeepsToItsLimits) {
  const Graph graph = grid_graph(30, 30);
  RelaxationOptions options;
  options.max_greedy_steps = 2;
  options.max_macrosteps = 1;
  const Relaxation result = run(graph, {0, 1, 2, 3}, options);
  EXPECT_EQ(result.stop_reason, StopReason::limit);
  EXPECT_EQ(steps_in(result, Phase::greedy), 2U);
  EXPECT_EQ(steps_in(result, Phase::precise), 1U);
  options.max_greedy_steps = options.max_macrosteps = 0;
  EXPECT_EQ(run(graph, {0, 1, 2, 3}, options).seeds, (std::vector<NodeId>{0, 1, 2, 3}));
}

// An engine whose seeds swing between two places for ever: the loop must notice.
TEST(Relaxation, NoticesSeedsThatComeBack) {
  class Swinging final : public Engine {
   public:
    void partition(std::span<const NodeId>) override {}
    std::span<const Score> region_scores() const override { return score_; }
    std::uint64_t state_digest(std::span<const NodeId> seeds) const override { return seeds[0]; }
    std::vector<NodeId> greedy_candidates(std::span<const NodeId>, bool) override {
      return {no_id};
    }
    std::vector<Microstep> macrostep(std::vector<NodeId>& seeds, const MacrostepOptions&,
                                     const KeepGoing&) override {
      seeds[0] = 1 - seeds[0];
      return {{1, 0}};
    }
    const Partition& current() const override { return partition_; }
    const KernelSeconds& seconds() const override { return seconds_; }

   private:
    std::vector<Score> score_{1};
    Partition partition_;
    KernelSeconds seconds_;
  };
  Swinging engine;
  RelaxationState state;
  state.seeds = {0};
  for (const std::string time : {"first", "resumed"}) {
    const Relaxation result = relax(grid_graph(1, 2), engine, state, {});
    EXPECT_EQ(result.stop_reason, StopReason::recurred) << time;
    EXPECT_EQ(steps_in(result, Phase::precise), 2U) << time;
  }
}

// Without masses every state is as good as any other, and there are more than can be met.
TEST(Relaxation, EndsWhereNothingIsBetter) {
  std::vector<UndirectedArc> links;
  for (NodeId v = 0; v < 60; ++v) {
    for (const NodeId further : {1U, 7U}) links.push_back({v, (v + further) % 60, 1.0});
  }
  const Graph graph = make_graph(links, std::vector<double>(60, 0.0));
  RelaxationOptions options;
  options.greedy = GreedyMode::off;
  options.macrostep_skip = false;
  const Relaxation result = run(graph, random_nodes(1, 60, 9), options);
  EXPECT_EQ(result.stop_reason, StopReason::recurred);
  EXPECT_LE(result.steps.size(), 101U);  // and not thousands
}

// Twelve regions on the sphere should come near the dodecahedron's.
TEST(Relaxation, MakesEvenRegionsOnTheSphere) {
  const Mesh mesh = icosphere(20000);
  const MeshGraph made = make_mesh_graph(mesh, find_edges(mesh), {});
  const auto seeds =
      choose_seeds(made.graph, connected_components(made.graph), SeedInit::farthest, 12, 1);
  const Relaxation result = run(made.graph, seeds);
  EXPECT_EQ(result.stop_reason, StopReason::converged);
  std::vector<int> size(12, 0);
  for (const Key key : result.partition.key) ++size[region_of(key)];
  for (const int s : size) EXPECT_NEAR(s, static_cast<double>(mesh.vertex_count()) / 12, 300);
}

}  // namespace
}  // namespace geolloyd
