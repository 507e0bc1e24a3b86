// What is done region by region once there is a partition: subtree sums, scores, macrosteps.
#include <numeric>
#include <string>

#include "bench/suites/suites.h"
#include "bench/support/run.h"
#include "core/lloyd/reference_engine.h"
#include "core/voronoi/fingerprint.h"
#include "core/voronoi/forest.h"
#include "parallel/engine/incremental_partition.h"

namespace geolloyd {
namespace {

SubtreeSums empty_sums(const Graph& graph) {
  return {std::vector<std::uint64_t>(graph.node_count()),
          std::vector<std::uint64_t>(graph.node_count())};
}

// The root of a tree has the sums of its region.
bool add_up_at_seeds(const Graph& graph, const Solved& solved, const SubtreeSums& sums) {
  std::uint64_t cost = 0;
  std::uint64_t mass = 0;
  for (const NodeId v : solved.settled) {
    cost += distance_of(solved.partition.key[v]);
    mass += graph.mass[v];
  }
  for (const NodeId s : solved.seeds) {
    cost -= sums.cost[s];
    mass -= sums.mass[s];
  }
  return cost == 0 && mass == 0;
}

void sum_sequentially(Run& run) {
  const Graph& graph = run.inputs().graph();
  const Solved& solved = run.inputs().solved(run.seeds());
  SubtreeSums sums = empty_sums(graph);
  const auto work = [&] { sum_subtrees(graph, solved.partition, solved.settled, sums); };
  run.verify("the sums do not add up", [&] {
    work();
    return add_up_at_seeds(graph, solved, sums);
  });
  run.measure(work);
  run.rate("nodes/s", graph.node_count());
}

// The parallel sums are those at the seeds' neighbours only; nobody asks for others.
bool same_around_seeds(const Graph& graph, const Solved& solved, const SubtreeSums& sums) {
  SubtreeSums expected = empty_sums(graph);
  sum_subtrees(graph, solved.partition, solved.settled, expected);
  for (RegionId r = 0; r < solved.seeds.size(); ++r) {
    for (const NodeId v : graph.neighbours(solved.seeds[r])) {
      if (region_of(solved.partition.key[v]) != r) continue;
      if (sums.cost[v] != expected.cost[v] || sums.mass[v] != expected.mass[v]) return false;
    }
  }
  return true;
}

void sum_in_parallel(Run& run) {
  const Graph& graph = run.inputs().graph();
  const Solved& solved = run.inputs().solved(run.seeds());
  Scheduler scheduler(run.threads());
  KernelSeconds seconds;
  IncrementalPartition free(scheduler, graph, Frontier::delta, seconds);
  free.update(solved.seeds);
  const auto work = [&] { free.update_sums(); };
  run.verify("not the sums of the sequential code", [&] {
    work();
    return same_around_seeds(graph, solved, free.sums());
  });
  run.measure([&] { free.forget_sums(); }, work);
  run.rate("nodes/s", graph.node_count());
}

void score_sequentially(Run& run) {
  const Graph& graph = run.inputs().graph();
  const Solved& solved = run.inputs().solved(run.seeds());
  std::vector<Score> score;
  const auto work = [&] {
    score.assign(solved.seeds.size(), 0);
    add_scores(graph, solved.partition.key, solved.settled, score);
  };
  run.verify("not the scores", [&] {
    work();
    return score == solved.score;
  });
  run.measure(work);
  run.rate("nodes/s", graph.node_count());
}

// The same as derive_parents_and_totals, by core's functions one after the other.
void find_totals_sequentially(Run& run) {
  const Graph& graph = run.inputs().graph();
  const Solved& solved = run.inputs().solved(run.seeds());
  Partition partition = solved.partition;
  std::vector<Score> score;
  const auto work = [&] {
    derive_parents(graph, partition.key, solved.settled, partition.parent);
    score.assign(solved.seeds.size(), 0);
    add_scores(graph, partition.key, solved.settled, score);
    return digest(solved.seeds, partition);
  };
  run.verify("not the parents or scores", [&] {
    partition.parent.assign(graph.node_count(), no_id);
    work();
    return partition.parent == solved.partition.parent && score == solved.score;
  });
  run.measure(work);
  run.rate_of_graph(graph);
}

bool same_totals(const RegionTotals& totals, const Solved& solved) {
  std::uint64_t sum = 0;
  for (const std::uint64_t d : totals.digest) sum += d;
  return totals.score == solved.score &&
         digest(solved.seeds, sum) == digest(solved.seeds, solved.partition);
}

void find_totals_in_parallel(Run& run) {
  const Graph& graph = run.inputs().graph();
  const Solved& solved = run.inputs().solved(run.seeds());
  const std::size_t regions = solved.seeds.size();
  Scheduler scheduler(run.threads());
  RegionNodes members;
  find_region_nodes(scheduler, solved.partition.key, regions, members);
  std::vector<RegionId> all(regions);
  std::iota(all.begin(), all.end(), RegionId{0});
  const std::vector<RegionSlice> slices = cut_into_slices(members, all);
  Partition partition{solved.partition.key, std::vector<NodeId>(graph.node_count(), no_id)};
  RegionTotals totals{std::vector<Score>(regions), std::vector<std::uint64_t>(regions)};
  KernelSeconds seconds;
  const auto work = [&] {
    derive_parents_and_totals(scheduler, graph, members, slices, partition, totals, seconds);
  };
  run.verify("not the parents or totals of the sequential code", [&] {
    work();
    return partition.parent == solved.partition.parent && same_totals(totals, solved);
  });
  run.measure(work);
  run.rate_of_graph(graph);
}

// From a fresh partition. Visits are those of the definition, however few an engine makes.
void measure_macrostep(Run& run, Engine& engine) {
  const std::vector<NodeId>& seeds = run.inputs().solved(run.seeds()).seeds;
  const Rest& expected = run.inputs().rest(run.seeds());
  const auto prepare = [&] { engine.partition(seeds); };
  const auto work = [&] { return macrostep(engine, seeds); };
  run.verify("not the moves of the reference", [&] {
    prepare();
    return work() == expected;
  });
  run.measure(prepare, work);
  run.rate("node visits/s", count_visits(expected.microsteps));
  run.count("microsteps", expected.microsteps.size());
}

void add_sequential_stages(const BenchMesh& mesh) {
  const Setting setting{mesh.usual_seeds, Setting::sequential, {}};
  add_benchmark("sums", mesh, setting, sum_sequentially);
  add_benchmark("scoring/scores", mesh, setting, score_sequentially);
  add_benchmark("scoring/totals", mesh, setting, find_totals_sequentially);
  add_benchmark("macrostep", mesh, setting, [](Run& run) {
    measure_macrostep(run, *make_reference_engine(run.inputs().graph()));
  });
}

void add_parallel_stages(const BenchMesh& mesh, std::size_t threads) {
  const Setting setting{mesh.usual_seeds, threads, {}};
  add_benchmark("sums", mesh, setting, sum_in_parallel);
  add_benchmark("scoring/totals", mesh, setting, find_totals_in_parallel);
  add_benchmark("macrostep", mesh, setting, [](Run& run) {
    Scheduler scheduler(run.threads());
    measure_macrostep(run, *make_parallel_engine(scheduler, run.inputs().graph()));
  });
}

}  // namespace

void add_region_benchmarks(const BenchMesh& mesh) {
  add_sequential_stages(mesh);
  for (const std::size_t threads : thread_ladder()) add_parallel_stages(mesh, threads);
}

}  // namespace geolloyd
