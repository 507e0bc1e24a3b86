// Rounds of improvement: they never raise the energy, give the same bits with every engine, and
// can be left and taken up anywhere.
#include "core/lloyd/improvement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/lloyd/paired_engine.h"
#include "core/seeds/seeds.h"
#include "core/shapes/shapes.h"
#include "tests/support/agreement.h"
#include "tests/support/random_graph.h"

namespace geolloyd {
namespace {

RelaxationOptions with_rounds(std::uint32_t rounds) {
  RelaxationOptions options;
  options.improvement_rounds = rounds;
  return options;
}

Graph graph_of(const Mesh& mesh, GraphKind kind) {
  return make_mesh_graph(mesh, find_edges(mesh), {kind, {}, {}}).graph;
}

ScoredPartition partition(const Graph& graph, const std::vector<NodeId>& seeds) {
  const auto engine = make_reference_engine(graph);
  engine->partition(seeds);
  const auto scores = engine->region_scores();
  return {seeds, engine->current().key, {scores.begin(), scores.end()}};
}

Score total(const ScoredPartition& partition) {
  Score sum = 0;
  for (const Score s : partition.scores) sum += s;
  return sum;
}

void expect_different(const std::vector<NodeId>& seeds, std::size_t count) {
  EXPECT_EQ(std::set<NodeId>(seeds.begin(), seeds.end()).size(), count);
}

TEST(Improvement, NeverRaisesTheEnergyOnAnyGraph) {
  Scheduler scheduler(2, Backend::tbb);
  std::size_t lowered = 0;
  for (std::uint64_t trial = 0; trial < 150; ++trial) {
    const NodeId nodes = 2 + random_number(trial, 0, 60);
    const Graph graph = trial % 3 == 0 ? random_graph(trial, nodes) : grid_graph(nodes, 5);
    const auto count = static_cast<NodeId>(graph.node_count());
    const auto seeds = random_nodes(trial, count, 1 + random_number(trial, 1, count));
    SCOPED_TRACE(testing::Message() << "trial " << trial << ", seeds " << seeds.size());
    const Relaxation plain = relax_by_reference(graph, seeds, {});
    const Relaxation improved = relax_by_reference(graph, seeds, with_rounds(4));
    ASSERT_LE(improved.energy, plain.energy);
    lowered += improved.energy < plain.energy ? 1 : 0;
    expect_different(improved.seeds, seeds.size());
    Score last = never_scored;
    for (const Step& step : improved.steps) {
      if (step.phase != Phase::improvement) continue;
      ASSERT_LE(step.score, last);
      last = step.score;
    }
    expect_same(improved,
                relax_in_parallel(scheduler, Frontier::automatic, graph, seeds, with_rounds(4)));
    if (testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(lowered, 20U);
}

// With clusters of both partitions chosen by their scores, the whole costs no more than either.
TEST(Improvement, KeepsOfTwoPartitionsWhatIsLower) {
  for (std::uint64_t trial = 0; trial < 100; ++trial) {
    const Graph graph = grid_graph(12, 12);
    const ScoredPartition base = partition(graph, random_nodes(trial, 144, 10));
    ScoredPartition other = base;
    other.seeds = perturb(graph, base, trial);
    expect_different(other.seeds, 10);
    other = partition(graph, other.seeds);
    const std::vector<std::uint8_t> is_lower = lower_clusters(base, other);
    std::vector<NodeId> mixed = base.seeds;
    for (std::size_t r = 0; r < mixed.size(); ++r) {
      if (is_lower[r] != 0) mixed[r] = other.seeds[r];
    }
    expect_different(mixed, 10);
    EXPECT_LE(total(partition(graph, mixed)), std::min(total(base), total(other)));
  }
}

TEST(Improvement, LeavesEachComponentASeed) {
  std::vector<UndirectedArc> links;
  for (NodeId v = 0; v + 1 < 100; ++v) {
    if (v != 9 && v != 12) links.push_back({v, v + 1, 1.0});
  }
  const Graph graph = make_graph(links, std::vector<double>(100, 1.0));
  const Components components = connected_components(graph);
  const Relaxation result = relax_by_reference(graph, {0, 1, 2, 3, 4, 5, 11, 99}, with_rounds(10));
  std::set<std::uint32_t> with_seed;
  for (const NodeId s : result.seeds) with_seed.insert(components.component_of[s]);
  EXPECT_EQ(with_seed.size(), 3U);
  EXPECT_LT(result.energy, relax_by_reference(graph, {0, 1, 2, 3, 4, 5, 11, 99}, {}).energy / 4);
}

TEST(Improvement, HasOneCourseOnAllEnginesAndThreads) {
  const Mesh mesh = creature(800, 1);
  for (const GraphKind kind : {GraphKind::vertex, GraphKind::mixed}) {
    const Graph graph = graph_of(mesh, kind);
    const auto seeds = choose_seeds(graph, connected_components(graph), SeedInit::random, 30, 1);
    const Relaxation expected = relax_by_reference(graph, seeds, with_rounds(5));
    EXPECT_LT(expected.energy, 0.99 * relax_by_reference(graph, seeds, {}).energy);
    for (const std::size_t threads : {1U, 2U, 5U}) {
      Scheduler scheduler(threads, Backend::tbb);
      for (const Frontier frontier : all_frontiers) {
        expect_same(expected, relax_in_parallel(scheduler, frontier, graph, seeds, with_rounds(5)));
      }
    }
  }
}

// A run of more rounds begins as a run of fewer does; its state between two rounds is all it needs.
TEST(Improvement, GoesOnFromAnyRound) {
  const Graph graph = graph_of(creature(2000, 1), GraphKind::vertex);
  const auto seeds = choose_seeds(graph, connected_components(graph), SeedInit::random, 40, 1);
  const auto engine = make_reference_engine(graph);
  RelaxationState state;
  state.seeds = seeds;
  std::vector<RelaxationState> states;
  const Relaxation whole = relax(graph, *engine, state, with_rounds(6), {},
                                 [&](const RelaxationState& s) { states.push_back(s); });
  for (RelaxationState from : states) {
    if (from.steps.back().phase == Phase::greedy) continue;
    expect_same(whole, relax(graph, *engine, from, with_rounds(6)));
  }
  RelaxationState fewer;
  fewer.seeds = seeds;
  relax(graph, *engine, fewer, with_rounds(2));
  expect_same(whole, relax(graph, *engine, fewer, with_rounds(6)));
}

TEST(Improvement, KeepsTheBestWhenInterrupted) {
  const Graph graph = graph_of(creature(2000, 1), GraphKind::vertex);
  const auto seeds = choose_seeds(graph, connected_components(graph), SeedInit::random, 40, 1);
  const double converged = relax_by_reference(graph, seeds, {}).energy;
  for (std::uint32_t last = 1; last < 6; ++last) {
    const auto engine = make_reference_engine(graph);
    const Relaxation result =
        relax(graph, *engine, seeds, with_rounds(10), [&](const Progress& progress) {
          return progress.phase != Phase::improvement || progress.step < last;
        });
    EXPECT_EQ(result.stop_reason, StopReason::interrupted);
    EXPECT_EQ(result.steps.back().phase, Phase::improvement);
    EXPECT_LE(result.energy, converged);
    EXPECT_LE(result.energy, result.steps.back().energy);
  }
}

TEST(Improvement, EndsAtItsLimitInSeconds) {
  const Graph graph = grid_graph(20, 20);
  RelaxationOptions options = with_rounds(RelaxationOptions::no_limit);
  options.improvement_seconds = 1e-9;
  const Relaxation result = relax_by_reference(graph, {0, 1, 2}, options);
  EXPECT_EQ(result.stop_reason, StopReason::converged);
  EXPECT_EQ(std::count_if(result.steps.begin(), result.steps.end(),
                          [](const Step& s) { return s.phase == Phase::improvement; }),
            1);
}

TEST(Improvement, OfOneSeedAndOfAllNodesIsNone) {
  const Graph graph = grid_graph(6, 6);
  const Relaxation one = relax_by_reference(graph, {3}, with_rounds(3));
  EXPECT_EQ(one.energy, relax_by_reference(graph, {3}, {}).energy);
  std::vector<NodeId> all(36);
  for (NodeId v = 0; v < 36; ++v) all[v] = v;
  const Relaxation whole = relax_by_reference(graph, all, with_rounds(3));
  EXPECT_EQ(whole.energy, 0);
  EXPECT_EQ(whole.seeds, all);
}

}  // namespace
}  // namespace geolloyd
