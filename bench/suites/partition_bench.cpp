// Multi-source searches, regions free: keys alone, whole partitions from scratch, and partitions
// again after all seeds have moved by an arc.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "bench/suites/suites.h"
#include "bench/support/frontiers.h"
#include "bench/support/run.h"
#include "core/lloyd/reference_engine.h"
#include "core/voronoi/dijkstra.h"
#include "parallel/engine/delta_stepping.h"
#include "parallel/engine/incremental_partition.h"

namespace geolloyd {
namespace {

bool are_equal(const Partition& a, const Partition& b) {
  return a.key == b.key && a.parent == b.parent;
}

void search_by_heap(Run& run) {
  const Graph& graph = run.inputs().graph();
  const Solved& expected = run.inputs().solved(run.seeds());
  IndexedHeap heap(graph.node_count());
  std::vector<Key> keys;
  std::vector<NodeId> settled;
  const auto search = [&] { search_free(graph, expected.seeds, heap, keys, settled); };
  run.verify("not the certified keys", [&] {
    search();
    return keys == expected.partition.key;
  });
  run.measure(search);
  run.rate_of_graph(graph);
}

// `mean_arcs`: the width of a bucket; 0 leaves it to DeltaStepping.
void search_by_delta(Run& run, double mean_arcs) {
  const Graph& graph = run.inputs().graph();
  const Solved& expected = run.inputs().solved(run.seeds());
  const double total = std::accumulate(graph.length.begin(), graph.length.end(), 0.0);
  const double mean = total / static_cast<double>(std::max<std::size_t>(graph.arc_count(), 1));
  Scheduler scheduler(run.threads());
  DeltaStepping delta_stepping(scheduler, graph,
                               static_cast<std::uint32_t>(std::ceil(mean_arcs * mean)));
  std::vector<Key> keys;
  const auto search = [&] { delta_stepping.search(expected.seeds, keys); };
  run.verify("not the keys of the heap", [&] {
    search();
    return keys == expected.partition.key;
  });
  run.measure(search);
  run.rate_of_graph(graph);
}

void partition_by_reference(Run& run) {
  const Graph& graph = run.inputs().graph();
  const Solved& expected = run.inputs().solved(run.seeds());
  const auto engine = make_reference_engine(graph);
  const auto work = [&] { engine->partition(expected.seeds); };
  run.verify("not the certified partition", [&] {
    work();
    return are_equal(engine->current(), expected.partition) &&
           std::ranges::equal(engine->region_scores(), expected.score);
  });
  run.measure(work);
  run.rate_of_graph(graph);
}

bool is_solved(const IncrementalPartition& free, const Solved& expected) {
  return are_equal(free.partition(), expected.partition) && free.totals().score == expected.score;
}

void partition_from_scratch(Run& run, Frontier frontier) {
  const Graph& graph = run.inputs().graph();
  const Solved& expected = run.inputs().solved(run.seeds());
  Scheduler scheduler(run.threads());
  KernelSeconds seconds;
  IncrementalPartition free(scheduler, graph, frontier, seconds);
  const auto work = [&] { free.update(expected.seeds); };
  run.verify("not the partition of the reference", [&] {
    work();
    return is_solved(free, expected);
  });
  run.measure([&] { free.forget(); }, work);
  run.rate_of_graph(graph);
}

std::size_t count_moved(const Solved& a, const Solved& b) {
  std::size_t moved = 0;
  for (std::size_t r = 0; r < a.seeds.size(); ++r) moved += a.seeds[r] != b.seeds[r] ? 1 : 0;
  return moved;
}

// There and back, so that every turn starts from the partition of seeds one arc away; and from
// their sums, as in the greedy phase.
void repair(Run& run, Frontier frontier) {
  const Graph& graph = run.inputs().graph();
  const Solved* from = &run.inputs().solved(run.seeds());
  const Solved* to = &run.inputs().moved(run.seeds());
  Scheduler scheduler(run.threads());
  KernelSeconds seconds;
  IncrementalPartition free(scheduler, graph, frontier, seconds);
  free.update(from->seeds);
  const auto find_sums = [&] { free.update_sums(); };
  const auto move = [&] {
    free.update(to->seeds);
    std::swap(from, to);
  };
  run.verify("not the partition of the reference", [&] {
    bool is_right = true;
    for (int way = 0; way < 2; ++way) {
      find_sums();
      move();
      is_right = is_right && is_solved(free, *from);
    }
    return is_right;
  });
  run.measure(find_sums, move);
  run.rate_of_graph(graph);
  run.count("seeds_moved", count_moved(*from, *to));
}

void add_searches(const BenchMesh& mesh, std::size_t seeds) {
  add_benchmark("search/heap", mesh, {seeds, Setting::sequential, {}}, search_by_heap);
  for (const std::size_t threads : thread_ladder()) {
    add_benchmark("search/delta", mesh, {seeds, threads, {}},
                  [](Run& run) { search_by_delta(run, 0); });
  }
}

void add_delta_sweep(const BenchMesh& mesh) {
  constexpr std::pair<const char*, double> widths[] = {{"0.25", 0.25}, {"0.5", 0.5}, {"1", 1},
                                                       {"2", 2},       {"4", 4},     {"8", 8}};
  for (const std::size_t threads : thread_ladder()) {
    for (const auto& [name, mean_arcs] : widths) {
      add_benchmark("search/delta", mesh, {mesh.usual_seeds, threads, std::string("delta:") + name},
                    [mean_arcs = mean_arcs](Run& run) { search_by_delta(run, mean_arcs); });
    }
  }
}

void add_partitions(const BenchMesh& mesh, std::size_t seeds) {
  add_benchmark("partition/reference", mesh, {seeds, Setting::sequential, {}},
                partition_by_reference);
  for (const auto& [name, frontier] : frontiers) {
    for (const std::size_t threads : thread_ladder()) {
      const Setting setting{seeds, threads, {}};
      add_benchmark(std::string("partition/") + name, mesh, setting,
                    [frontier = frontier](Run& run) { partition_from_scratch(run, frontier); });
      add_benchmark(std::string("repair/") + name, mesh, setting,
                    [frontier = frontier](Run& run) { repair(run, frontier); });
    }
  }
}

}  // namespace

void add_partition_benchmarks(const BenchMesh& mesh) {
  for (const std::size_t seeds : mesh.seed_ladder) add_searches(mesh, seeds);
  add_delta_sweep(mesh);
  for (const std::size_t seeds : mesh.seed_ladder) add_partitions(mesh, seeds);
}

}  // namespace geolloyd
