#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/lloyd/reference_engine.h"
#include "core/lloyd/relaxation.h"
#include "tests/support/random_graph.h"
#include "tests/support/same_relaxation.h"

namespace geolloyd {
namespace {

// A relaxation by single steps.
struct Walker {
  Walker(const Graph& on_graph, const std::vector<NodeId>& seeds)
      : graph(on_graph), engine(make_reference_engine(on_graph)) {
    state.seeds = seeds;
  }

  std::optional<StopReason> step(SeedTrails* trails = nullptr) {
    return take_step(graph, *engine, state, options, {}, trails);
  }

  Relaxation result() { return relax(graph, *engine, state, options); }

  const Graph& graph;
  std::unique_ptr<Engine> engine;
  RelaxationOptions options;
  RelaxationState state;
};

template <class Check>
void for_random_walkers(Check&& check) {
  for (std::uint64_t random_seed = 0; random_seed < 60; ++random_seed) {
    SCOPED_TRACE(random_seed);
    const Graph graph = random_seed % 2 == 0 ? grid_graph(6, 9)  // many nodes are equally good
                                             : random_connected_graph(random_seed, 60);
    const auto nodes = static_cast<NodeId>(graph.node_count());
    Walker walker(graph, random_nodes(random_seed, nodes, 1 + random_seed % 7));
    walker.options.greedy = static_cast<GreedyMode>(random_seed % 3);
    walker.options.improvement_rounds = random_seed % 5 == 0 ? 3 : 0;
    check(walker);
  }
}

TEST(Stepping, StepByStepIsTheWholeRelaxation) {
  for_random_walkers([](Walker& walker) {
    const std::vector<NodeId> first = walker.state.seeds;
    std::optional<StopReason> end;
    for (std::size_t steps = 0; !end; ++steps) {
      ASSERT_EQ(walker.state.steps.size(), steps);
      const Phase phase = next_phase(walker.state, walker.options);
      end = walker.step();
      if (!end) {
        ASSERT_EQ(walker.state.steps.back().phase, phase);
      }
    }
    const auto engine = make_reference_engine(walker.graph);
    const Relaxation whole = relax(walker.graph, *engine, first, walker.options);
    ASSERT_EQ(*end, whole.stop_reason);
    expect_same(whole, walker.result());
  });
}

// Where it is left after so many steps, it is the relaxation with these limits.
TEST(Stepping, LeftEarlyIsTheRelaxationWithLimits) {
  for_random_walkers([](Walker& walker) {
    walker.options.improvement_rounds = 0;
    const std::vector<NodeId> first = walker.state.seeds;
    const std::uint32_t greedy_steps = 1;
    for (std::uint32_t i = 0; i < greedy_steps; ++i) {
      if (next_phase(walker.state, walker.options) == Phase::greedy) walker.step();
    }
    walker.options.max_greedy_steps = greedy_steps;
    walker.options.max_macrosteps = 2;
    while (!walker.step()) {
    }
    const auto engine = make_reference_engine(walker.graph);
    expect_same(relax(walker.graph, *engine, first, walker.options), walker.result());
  });
}

TEST(Stepping, TrailsLeadFromSeedToSeedByTheMicrosteps) {
  std::size_t moves = 0;
  for_random_walkers([&moves](Walker& walker) {
    SeedTrails trails = {{0}};
    for (;;) {
      const std::vector<NodeId> before = walker.state.seeds;
      if (walker.step(&trails)) break;
      const Step& step = walker.state.steps.back();
      if (step.phase != Phase::precise) {
        ASSERT_TRUE(trails.empty());
        continue;
      }
      ASSERT_EQ(trails.size(), before.size());
      std::vector<std::uint32_t> moved(step.microsteps.size(), 0);
      for (std::size_t r = 0; r < trails.size(); ++r) {
        ASSERT_EQ(trails[r].empty() ? before[r] : trails[r].back(), walker.state.seeds[r]);
        ASSERT_LT(trails[r].size(), moved.size());
        for (std::size_t i = 0; i < trails[r].size(); ++i) ++moved[i];
      }
      for (std::size_t i = 0; i < moved.size(); ++i) {
        ASSERT_EQ(moved[i], step.microsteps[i].seeds_moved);
        moves += moved[i];
      }
    }
  });
  EXPECT_GT(moves, 100U);
}

TEST(Stepping, AnInterruptedStepIsNotTaken) {
  for_random_walkers([](Walker& walker) {
    const RelaxationState before = walker.state;
    const auto stop = [](const Progress&) { return false; };
    EXPECT_EQ(take_step(walker.graph, *walker.engine, walker.state, walker.options, stop),
              StopReason::interrupted);
    EXPECT_EQ(walker.state.seeds, before.seeds);
    EXPECT_TRUE(walker.state.steps.empty());
    while (!walker.step()) {
    }
    const auto engine = make_reference_engine(walker.graph);
    expect_same(relax(walker.graph, *engine, before.seeds, walker.options), walker.result());
  });
}

}  // namespace
}  // namespace geolloyd
