// The parallel engine against the sequential reference: everything equal, whatever the graph, the
// options, the number of threads, the frontier, the backend.
#include "tests/support/agreement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>

#include "core/graph/mesh_graph.h"
#include "core/seeds/seeds.h"
#include "core/shapes/shapes.h"
#include "tests/support/random_graph.h"
#include "tests/support/sanitizers.h"

namespace geolloyd {
namespace {

// Every scheduler of the sweep, made once.
const std::vector<std::unique_ptr<Scheduler>>& schedulers() {
  static const auto all = [] {
    std::vector<std::unique_ptr<Scheduler>> made;
    for (const Backend backend : all_backends) {
      for (const std::size_t threads : {1U, 2U, 3U, 8U}) {
        made.push_back(std::make_unique<Scheduler>(threads, backend));
      }
    }
    return made;
  }();
  return all;
}

std::string describe(const Scheduler& scheduler, Frontier frontier) {
  return std::to_string(scheduler.threads()) + " threads, backend " +
         std::to_string(static_cast<int>(scheduler.backend())) + ", frontier " +
         std::to_string(static_cast<int>(frontier));
}

// All combinations take minutes, and sanitizers make that ten times as long: one in three, or in
// eleven, is tried, and the next case tries others.
const std::size_t stride = std::getenv("GEOLLOYD_LONG_TESTS") != nullptr ? 1
                           : under_sanitizer                             ? 11
                                                                         : 3;

// Calls check(scheduler, frontier) for all combinations, until one fails.
template <class Check>
void for_all_teams(std::span<const Frontier> frontiers, Check&& check) {
  static std::size_t combination = 0;
  for (const auto& scheduler : schedulers()) {
    for (const Frontier frontier : frontiers) {
      if (combination++ % stride != 0) continue;
      SCOPED_TRACE(describe(*scheduler, frontier));
      check(*scheduler, frontier);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

void expect_agreement_everywhere(const Graph& graph, const std::vector<NodeId>& seeds,
                                 const RelaxationOptions& options,
                                 std::span<const Frontier> frontiers = all_frontiers) {
  const Relaxation expected = relax_by_reference(graph, seeds, options);
  for_all_teams(frontiers, [&](Scheduler& scheduler, Frontier frontier) {
    expect_same(expected, relax_in_parallel(scheduler, frontier, graph, seeds, options));
  });
}

std::vector<RelaxationOptions> all_options() {
  std::vector<RelaxationOptions> all;
  for (const GreedyMode greedy : {GreedyMode::off, GreedyMode::standard, GreedyMode::extended}) {
    for (const bool microstep_skip : {true, false}) {
      for (const bool macrostep_skip : {true, false}) {
        RelaxationOptions options;
        options.greedy = greedy;
        options.microstep_skip = microstep_skip;
        options.macrostep_skip = macrostep_skip;
        all.push_back(options);
      }
    }
  }
  return all;
}

// A metric that turns and changes over the surface.
std::vector<TangentSpace> swirling_field(const Mesh& mesh) {
  std::vector<TangentSpace> spaces;
  for (const Vec3& p : mesh.positions) {
    const double turn = 3 * p.x() + 2 * p.z();
    spaces.push_back({Vec3(std::cos(turn), std::sin(turn), 0),
                      Vec3(-std::sin(turn), std::cos(turn), 0), 1 + std::abs(p.y()),
                      3 - std::abs(p.x())});
  }
  return spaces;
}

using MeshCase = std::tuple<GraphKind, Norm, bool>;

class AgreementOnMeshes : public testing::TestWithParam<MeshCase> {};

TEST_P(AgreementOnMeshes, InAllModes) {
  const auto [kind, norm, anisotropic] = GetParam();
  const Mesh mesh = creature(500, 1);
  MeshGraphOptions options{kind, norm, {}};
  if (anisotropic) options.vertex_space = swirling_field(mesh);
  const MeshGraph made = make_mesh_graph(mesh, find_edges(mesh), options);
  const auto seeds =
      choose_seeds(made.graph, connected_components(made.graph), SeedInit::random, 12, 1);
  for (const RelaxationOptions& relaxation_options : all_options()) {
    expect_agreement_everywhere(made.graph, seeds, relaxation_options);
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Sweep, AgreementOnMeshes,
    testing::Combine(testing::Values(GraphKind::vertex, GraphKind::vertex_dense,
                                     GraphKind::triangle, GraphKind::triangle_dense,
                                     GraphKind::mixed, GraphKind::vertex_far),
                     testing::Values(Norm::geodesic, Norm::manhattan, Norm::linf),
                     testing::Bool()));

// Many equal lengths, links without length, isolated nodes, components without a seed.
TEST(Agreement, OnRandomGraphsThatAreHardOnTies) {
  for (std::uint64_t random_seed = 0; random_seed < 150; ++random_seed) {
    SCOPED_TRACE(random_seed);
    const NodeId nodes = 2 + random_number(random_seed, 1000, 50);
    const Graph graph = random_seed % 2 == 0 ? random_graph(random_seed, nodes)
                                             : random_connected_graph(random_seed, nodes);
    const std::uint32_t seeds = 1 + random_number(random_seed, 1001, nodes);
    const std::size_t turn = random_seed % all_options().size();
    expect_agreement_everywhere(graph, random_nodes(random_seed, nodes, seeds),
                                all_options()[turn]);
    if (HasFatalFailure()) return;
  }
}

TEST(Agreement, OnOneSeedAllSeedsAndOneNode) {
  const Graph graph = random_connected_graph(5, 60);
  expect_agreement_everywhere(graph, {17}, {});
  expect_agreement_everywhere(graph, random_nodes(1, 60, 60), {});
  expect_agreement_everywhere(grid_graph(1, 1), {0}, {});
  expect_agreement_everywhere(make_graph({}, std::vector<double>(5, 1.0)), {3, 1}, {});
}

// A hub with more neighbours than a search has lanes.
TEST(Agreement, OnStarsAndWheels) {
  constexpr NodeId rim = 60;
  for (const bool wheel : {false, true}) {
    std::vector<UndirectedArc> links;
    for (NodeId v = 1; v <= rim; ++v) {
      links.push_back({0, v, 10.0 + v % 7});
      if (wheel) links.push_back({v, v % rim + 1, 3.0 + v % 5});
      links.push_back({v, rim + v, 2.0 + v % 3});
    }
    std::vector<double> masses;
    for (NodeId v = 0; v <= 2 * rim; ++v) masses.push_back(1 + v % 4);
    const Graph graph = make_graph(links, masses);
    for (const RelaxationOptions& options : all_options()) {
      expect_agreement_everywhere(graph, {rim + 7}, options);
      expect_agreement_everywhere(graph, {0, 5, rim + 9}, options);
      if (HasFatalFailure()) return;
    }
  }
}

// A rim of short edges around a hub.
Graph fine_wheel(NodeId rim) {
  std::vector<UndirectedArc> links;
  for (NodeId v = 1; v <= rim; ++v) {
    links.push_back({0, v, 100.0 + v % 7});
    links.push_back({v, v % rim + 1, 600.0 / rim});
  }
  return make_graph(links, std::vector<double>(rim + 1, 1.0));
}

// Where most neighbours of the hub need no search, because one beside them is far too high.
TEST(Agreement, OnFineWheels) {
  const Graph graph = fine_wheel(400);
  for (const RelaxationOptions& options : all_options()) {
    expect_agreement_everywhere(graph, {0}, options);
    expect_agreement_everywhere(graph, {7, 150, 300}, options);
    if (HasFatalFailure()) return;
  }
}

// A search for each of the neighbours would take an hour.
TEST(ParallelEngine, RestsOnAHubOfVeryManyEdges) {
  constexpr NodeId rim = 100'000;
  const Graph graph = fine_wheel(rim);
  Scheduler scheduler(2);
  RelaxationOptions options;
  options.greedy = GreedyMode::off;
  const Relaxation relaxation =
      relax_in_parallel(scheduler, Frontier::automatic, graph, {0}, options);
  EXPECT_EQ(relaxation.stop_reason, StopReason::converged);
  EXPECT_EQ(relaxation.seeds, std::vector<NodeId>{0});
}

// Regions of many pieces, shared by several threads.
TEST(Agreement, OnFewLargeRegions) {
  const Mesh mesh = creature(30000, 1);
  const MeshGraph made = make_mesh_graph(mesh, find_edges(mesh), {});
  const auto components = connected_components(made.graph);
  RelaxationOptions options;
  options.max_greedy_steps = 25;
  options.max_macrosteps = 2;
  for (const std::size_t count : {1U, 2U, 3U}) {
    const auto seeds = choose_seeds(made.graph, components, SeedInit::random, count, 1);
    expect_agreement_everywhere(made.graph, seeds, options,
                                std::array{Frontier::delta, Frontier::regions});
    if (HasFatalFailure()) return;
  }
}

// A region so large that all threads share its searches.
TEST(Agreement, OnARegionForAllThreads) {
  const Mesh mesh = icosphere(80000);
  const MeshGraph made = make_mesh_graph(mesh, find_edges(mesh), {});
  RelaxationOptions options;
  options.greedy = GreedyMode::off;
  options.max_macrosteps = 2;
  const std::vector<NodeId> seeds = {100, 130, 40000};
  expect_agreement_everywhere(made.graph, seeds, options, std::array{Frontier::automatic});
}

// Engines may be asked for any seeds in any order, not only as the Lloyd loop does.
TEST(Agreement, OnSeedsThatJump) {
  for (std::uint64_t random_seed = 0; random_seed < 40; ++random_seed) {
    SCOPED_TRACE(random_seed);
    constexpr NodeId nodes = 80;
    const Graph graph = random_connected_graph(random_seed, nodes);
    const auto reference = make_reference_engine(graph);
    const auto parallel = make_parallel_engine(*schedulers()[random_seed % 8], graph);
    std::vector<NodeId> seeds = random_nodes(random_seed, nodes, 6);
    for (std::uint32_t turn = 0; turn < 16; ++turn) {
      reference->partition(seeds);
      parallel->partition(seeds);
      ASSERT_EQ(reference->current().key, parallel->current().key);
      ASSERT_EQ(reference->current().parent, parallel->current().parent);
      ASSERT_EQ(reference->state_digest(seeds), parallel->state_digest(seeds));
      ASSERT_TRUE(std::equal(reference->region_scores().begin(), reference->region_scores().end(),
                             parallel->region_scores().begin(), parallel->region_scores().end()));
      for (const bool extended : {turn % 2 == 0, turn % 3 == 0}) {
        ASSERT_EQ(reference->greedy_candidates(seeds, extended),
                  parallel->greedy_candidates(seeds, extended));
      }
      switch (random_number(random_seed, turn, 6)) {
        case 0:  // elsewhere, and another number of them
          seeds = random_nodes(random_seed + turn, nodes, 1 + turn);
          break;
        case 1:  // one goes far
          seeds = random_nodes(random_seed + turn, nodes, seeds.size());
          break;
        case 2: {  // within their regions
          const std::vector<std::uint8_t> keeps_seed(seeds.size(), turn % 3 == 0 ? 1 : 0);
          std::vector<NodeId> others = seeds;
          const auto go_on = [](std::uint32_t) { return true; };
          MacrostepOptions options{keeps_seed, turn % 2 == 0, true};
          SeedTrails expected_trails;
          SeedTrails trails;
          options.trails = &expected_trails;
          const std::vector<Microstep> expected = reference->macrostep(seeds, options, go_on);
          options.trails = &trails;
          ASSERT_EQ(expected, parallel->macrostep(others, options, go_on));
          ASSERT_EQ(seeds, others);
          ASSERT_EQ(expected_trails, trails);
          break;
        }
        case 3:  // more of them where they are
        case 4:  // and where they move to
          for (const NodeId s : random_nodes(random_seed + turn, nodes, 1 + turn % 3)) {
            if (std::find(seeds.begin(), seeds.end(), s) == seeds.end()) seeds.push_back(s);
          }
          if (random_number(random_seed, turn, 6) == 3) break;
          [[fallthrough]];
        default:  // by one arc, or not at all
          for (NodeId& s : seeds) {
            const auto neighbours = graph.neighbours(s);
            const NodeId next = neighbours[turn % neighbours.size()];
            if (std::find(seeds.begin(), seeds.end(), next) == seeds.end()) s = next;
          }
      }
    }
  }
}

TEST(Agreement, OfAnInterruptedRunThatGoesOn) {
  const Graph graph = grid_graph(40, 40);
  const std::vector<NodeId> seeds = {0, 1, 2, 3, 4, 5, 6, 7};
  for (const GreedyMode greedy : {GreedyMode::extended, GreedyMode::off}) {
    RelaxationOptions options;
    options.greedy = greedy;
    const Relaxation whole = relax_by_reference(graph, seeds, options);
    for_all_teams(std::array{Frontier::automatic}, [&](Scheduler& scheduler, Frontier frontier) {
      const auto engine = make_parallel_engine(scheduler, graph, frontier);
      for (const int calls : {1, 2, 5, 20}) {
        int left = calls;
        RelaxationState state;
        state.seeds = seeds;
        const Relaxation part =
            relax(graph, *engine, state, options, [&](const Progress&) { return --left > 0; });
        if (left > 0) continue;  // other threads were too fast to be asked more often
        ASSERT_EQ(part.stop_reason, StopReason::interrupted);
        for (const Step& step : part.steps) EXPECT_LE(part.energy, step.energy);
        expect_same(relax_by_reference(graph, part.seeds, options),
                    relax(graph, *engine, part.seeds, options));
        expect_same(whole, relax(graph, *engine, state, options));
        if (testing::Test::HasFatalFailure()) return;
      }
    });
  }
}

// An interrupt in the middle of a macrostep leaves some seeds moved and the rest not.
TEST(Agreement, AfterAMacrostepWasLeft) {
  const Graph graph = grid_graph(40, 40);
  const std::vector<NodeId> seeds = {0, 1, 2, 3, 4, 5, 6, 7};
  const std::vector<std::uint8_t> keeps_seed(seeds.size(), 0);
  const auto reference = make_reference_engine(graph);
  for_all_teams(std::array{Frontier::automatic}, [&](Scheduler& scheduler, Frontier frontier) {
    for (const int calls : {1, 3, 10}) {
      const auto engine = make_parallel_engine(scheduler, graph, frontier);
      std::vector<NodeId> moved = seeds;
      engine->partition(moved);
      int left = calls;
      engine->macrostep(moved, {keeps_seed, true, true}, [&](std::uint32_t) { return --left > 0; });
      ASSERT_LT(left, calls);  // asked at least once
      engine->partition(moved);
      reference->partition(moved);
      ASSERT_EQ(engine->current().key, reference->current().key);
      ASSERT_EQ(engine->current().parent, reference->current().parent);
    }
  });
}

// Whoever is told of the progress may throw, and use the engine again.
TEST(Agreement, AfterAnException) {
  const Mesh mesh = icosphere(80000);  // one region is for all threads, others are not
  const MeshGraph made = make_mesh_graph(mesh, find_edges(mesh), {});
  const std::vector<NodeId> seeds = {100, 130, 500, 40000};
  RelaxationOptions options;
  options.greedy = GreedyMode::off;
  options.max_macrosteps = 2;
  const Relaxation expected = relax_by_reference(made.graph, seeds, options);
  for_all_teams(std::array{Frontier::automatic}, [&](Scheduler& scheduler, Frontier frontier) {
    const auto engine = make_parallel_engine(scheduler, made.graph, frontier);
    for (int calls : {1, 2, 40}) {
      try {
        relax(made.graph, *engine, seeds, options, [&](const Progress&) {
          if (--calls <= 0) throw std::runtime_error("enough");
          return true;
        });
      } catch (const std::runtime_error&) {
      }
    }
    expect_same(expected, relax(made.graph, *engine, seeds, options));
  });
}

// Locked distances reach 2^31, and the way back to where a seed was comes on top.
TEST(Agreement, OnLongWaysAfterAMacrostep) {
  for (std::uint64_t random_seed = 0; random_seed < 300; ++random_seed) {
    SCOPED_TRACE(random_seed);
    std::uint64_t n = 0;
    const auto draw = [&](std::uint64_t bound) { return random_number(random_seed, n++, bound); };
    const NodeId nodes = 4 + draw(6);
    std::vector<UndirectedArc> links;
    for (NodeId v = 1; v < nodes; ++v) {
      links.push_back({v, draw(v), draw(3) == 0 ? 1.0 + draw(9) : 1000.0 + draw(999)});
    }
    for (int i = 0; i < 4; ++i) links.push_back({draw(nodes), draw(nodes), 1e6});
    const Graph graph = make_graph(links, std::vector<double>(nodes, 1.0));
    const auto reference = make_reference_engine(graph);
    const auto parallel = make_parallel_engine(*schedulers()[random_seed % 8], graph);
    std::vector<NodeId> seeds = random_nodes(random_seed, nodes, 2);
    const std::vector<std::uint8_t> keeps_seed(seeds.size(), 0);
    const auto go_on = [](std::uint32_t) { return true; };
    for (int turn = 0; turn < 4; ++turn) {
      reference->partition(seeds);
      parallel->partition(seeds);
      ASSERT_EQ(reference->current().key, parallel->current().key);
      std::vector<NodeId> others = seeds;
      reference->macrostep(seeds, {keeps_seed, true, true}, go_on);
      parallel->macrostep(others, {keeps_seed, true, true}, go_on);
      ASSERT_EQ(seeds, others);
      seeds = random_nodes(random_seed + 1000 + static_cast<std::uint64_t>(turn), nodes, 2);
    }
  }
}

TEST(Agreement, OnNoSeedsAndNoNodes) {
  expect_agreement_everywhere(grid_graph(3, 3), {}, {});
  expect_agreement_everywhere(make_graph({}, {}), {}, {});
}

// A node far from all others, so that nearly all buckets are empty; a hub whose neighbours hang
// from one another; more of them than there are nodes to a piece.
TEST(Agreement, OnFarNodesAndLargeHubs) {
  std::vector<UndirectedArc> links;
  constexpr NodeId rim = 6000;
  for (NodeId v = 1; v <= rim; ++v) {
    links.push_back({0, v, 2.0 * v});
    if (v > 1) links.push_back({v - 1, v, 1.0});
  }
  links.push_back({rim, rim + 1, 1e7});
  const Graph graph = make_graph(links, std::vector<double>(rim + 2, 1.0));
  RelaxationOptions options;
  options.max_greedy_steps = 3;
  options.max_macrosteps = 2;
  expect_agreement_everywhere(graph, {0}, options, std::array{Frontier::regions});
  expect_agreement_everywhere(graph, {3, 5000}, options, std::array{Frontier::regions});
}

// Threads that outnumber the cores meet in another order each time.
TEST(Agreement, OfManyRunsWithMoreThreadsThanCores) {
  const Mesh mesh = creature(2000, 2);
  const MeshGraph made = make_mesh_graph(mesh, find_edges(mesh), {});
  const auto seeds =
      choose_seeds(made.graph, connected_components(made.graph), SeedInit::random, 40, 3);
  const std::uint64_t fingerprint = relax_by_reference(made.graph, seeds, {}).fingerprint;
  for (const Backend backend : all_backends) {
    Scheduler scheduler(16, backend);
    for (int turn = 0; turn < 40; ++turn) {
      const Frontier frontier = all_frontiers[turn % 4];
      ASSERT_EQ(relax_in_parallel(scheduler, frontier, made.graph, seeds, {}).fingerprint,
                fingerprint);
    }
  }
}

}  // namespace
}  // namespace geolloyd
