// The result of a relaxation is the state of lowest energy met, the earliest of equals, however
// the relaxation ends. On meshes and graphs where the last state often is another one.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "core/graph/mesh_graph.h"
#include "core/lloyd/paired_engine.h"
#include "core/seeds/seeds.h"
#include "core/shapes/shapes.h"
#include "tests/support/agreement.h"

namespace geolloyd {
namespace {

constexpr std::array all_inits = {SeedInit::random, SeedInit::random_area, SeedInit::farthest,
                                  SeedInit::kmeans_plus_plus};
constexpr std::array all_modes = {GreedyMode::off, GreedyMode::standard, GreedyMode::extended};

template <class Check>
void for_all_relaxations(Check&& check) {
  for (const Mesh& mesh : {torus(500, 1), icosphere(500), irregular_plane(300, 1)}) {
    const MeshEdges edges = find_edges(mesh);
    for (const GraphKind kind : {GraphKind::vertex, GraphKind::triangle, GraphKind::mixed}) {
      const Graph graph = make_mesh_graph(mesh, edges, {kind, {}, {}}).graph;
      const Components components = connected_components(graph);
      for (const SeedInit init : all_inits) {
        for (const std::size_t count : {8U, 40U}) {
          const std::vector<NodeId> seeds = choose_seeds(graph, components, init, count, 1);
          for (const GreedyMode mode : all_modes) {
            SCOPED_TRACE(testing::Message() << "nodes " << graph.node_count() << ", seeds " << count
                                            << ", init " << int(init) << ", mode " << int(mode));
            RelaxationOptions options;
            options.greedy = mode;
            check(graph, seeds, options);
            if (testing::Test::HasFatalFailure()) return;
          }
        }
      }
    }
  }
}

Score total(const Relaxation& result) {
  return std::accumulate(result.region_score.begin(), result.region_score.end(), Score{0});
}

std::size_t best_step(const std::vector<Step>& steps) {
  const auto by_score = [](const Step& a, const Step& b) { return a.score < b.score; };
  return static_cast<std::size_t>(std::min_element(steps.begin(), steps.end(), by_score) -
                                  steps.begin());
}

// What a relaxation met: the state before each step, and the last one.
struct Course {
  std::vector<RelaxationState> states;
  Relaxation result;
};

Course follow(const Graph& graph, Engine& engine, const std::vector<NodeId>& seeds,
              const RelaxationOptions& options) {
  Course course;
  RelaxationState state;
  state.seeds = seeds;
  course.states = {state};
  course.result = relax(graph, engine, state, options, {},
                        [&](const RelaxationState& s) { course.states.push_back(s); });
  return course;
}

TEST(BestState, IsTheResultOfARelaxationThatConverges) {
  std::size_t last_is_not_best = 0;
  for_all_relaxations(
      [&](const Graph& graph, const std::vector<NodeId>& seeds, const RelaxationOptions& options) {
        const auto engine = make_reference_engine(graph);
        const Course course = follow(graph, *engine, seeds, options);
        const Relaxation& result = course.result;
        ASSERT_EQ(result.stop_reason, StopReason::converged);
        ASSERT_LE(result.energy, result.steps.front().energy);
        const std::size_t best = best_step(result.steps);
        ASSERT_EQ(total(result), result.steps[best].score);
        ASSERT_EQ(result.energy, result.steps[best].energy);
        ASSERT_EQ(result.seeds, course.states[best].seeds);
        last_is_not_best += result.seeds != course.states.back().seeds ? 1 : 0;
      });
  EXPECT_GE(last_is_not_best, 5U);  // or this test could not fail
}

// A limit leaves a state that no step began with: it counts, too.
TEST(BestState, IsTheResultAtALimit) {
  for_all_relaxations(
      [](const Graph& graph, const std::vector<NodeId>& seeds, RelaxationOptions options) {
        options.max_greedy_steps = options.max_macrosteps = 2;
        const auto engine = make_reference_engine(graph);
        const Course course = follow(graph, *engine, seeds, options);
        engine->partition(course.states.back().seeds);
        const std::span<const Score> scores = engine->region_scores();
        const Score last = std::accumulate(scores.begin(), scores.end(), Score{0});
        const std::size_t best = best_step(course.result.steps);
        const bool last_is_best = last < course.result.steps[best].score;
        ASSERT_EQ(course.result.seeds,
                  last_is_best ? course.states.back().seeds : course.states[best].seeds);
        ASSERT_EQ(total(course.result), std::min(last, course.result.steps[best].score));
      });
}

TEST(BestState, IsTheSameOfBothEnginesAndResumedFromAnyStep) {
  Scheduler scheduler(2, Backend::tbb);
  for_all_relaxations(
      [&](const Graph& graph, const std::vector<NodeId>& seeds, const RelaxationOptions& options) {
        const auto reference = make_reference_engine(graph);
        const auto parallel = make_parallel_engine(scheduler, graph, Frontier::automatic);
        PairedEngine pair(*reference, *parallel);
        const Course course = follow(graph, *reference, seeds, options);
        expect_same(course.result, relax(graph, *parallel, seeds, options));
        expect_same(course.result, relax(graph, pair, seeds, options));
        for (RelaxationState state : course.states) {
          expect_same(course.result, relax(graph, *parallel, state, options));
        }
      });
}

// Counts partitions and passes everything on.
class CountingEngine final : public Engine {
 public:
  explicit CountingEngine(Engine& engine) : engine_(engine) {}

  void partition(std::span<const NodeId> seeds) override {
    ++partitions;
    engine_.partition(seeds);
  }
  [[nodiscard]] std::span<const Score> region_scores() const override {
    return engine_.region_scores();
  }
  [[nodiscard]] std::uint64_t state_digest(std::span<const NodeId> seeds) const override {
    return engine_.state_digest(seeds);
  }
  std::vector<NodeId> greedy_candidates(std::span<const NodeId> seeds, bool extended) override {
    return engine_.greedy_candidates(seeds, extended);
  }
  std::vector<Microstep> macrostep(std::vector<NodeId>& seeds, const MacrostepOptions& options,
                                   const KeepGoing& keep_going) override {
    return engine_.macrostep(seeds, options, keep_going);
  }
  [[nodiscard]] const Partition& current() const override { return engine_.current(); }
  [[nodiscard]] const KernelSeconds& seconds() const override { return engine_.seconds(); }

  std::size_t partitions = 0;

 private:
  Engine& engine_;
};

TEST(BestState, CostsAPartitionOnlyWhereItIsNotTheLastOne) {
  for_all_relaxations(
      [](const Graph& graph, const std::vector<NodeId>& seeds, const RelaxationOptions& options) {
        const auto reference = make_reference_engine(graph);
        CountingEngine engine(*reference);
        const Course course = follow(graph, engine, seeds, options);
        const bool last_is_best = course.result.seeds == course.states.back().seeds;
        ASSERT_EQ(engine.partitions, course.result.steps.size() + (last_is_best ? 0 : 1));
      });
}

}  // namespace
}  // namespace geolloyd
