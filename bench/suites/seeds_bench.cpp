// Choosing the first seeds.
#include <algorithm>
#include <string>
#include <utility>

#include "bench/suites/suites.h"
#include "bench/support/run.h"
#include "core/seeds/seeds.h"
#include "core/voronoi/dijkstra.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {
namespace {

constexpr std::pair<const char*, SeedInit> inits[] = {{"farthest", SeedInit::farthest},
                                                      {"kmeans++", SeedInit::kmeans_plus_plus}};
constexpr std::uint64_t random_seed = 1;

std::vector<NodeId> choose(Run& run, SeedInit init, Runtime& runtime) {
  Inputs& in = run.inputs();
  return choose_seeds(in.graph(), in.components(), init, run.seeds(), random_seed, runtime);
}

// Different nodes that reach all others.
bool are_seeds(const Graph& graph, std::vector<NodeId> seeds) {
  IndexedHeap heap(graph.node_count());
  std::vector<Key> keys;
  std::vector<NodeId> settled;
  std::sort(seeds.begin(), seeds.end());
  if (std::adjacent_find(seeds.begin(), seeds.end()) != seeds.end()) return false;
  search_free(graph, seeds, heap, keys, settled);
  return settled.size() == graph.node_count();
}

void rate_seeds(Run& run) {
  run.rate("seeds/s", run.seeds());
  run.rate("nodes/s", run.inputs().graph().node_count());
}

void choose_sequentially(Run& run, SeedInit init) {
  const Graph& graph = run.inputs().graph();
  run.inputs().components();
  const auto work = [&] { return choose(run, init, reference_runtime()); };
  run.verify("not seeds", [&] {
    const std::vector<NodeId> seeds = work();
    return seeds.size() == run.seeds() && are_seeds(graph, seeds);
  });
  run.measure(work);
  rate_seeds(run);
}

void choose_in_parallel(Run& run, SeedInit init) {
  run.inputs().components();
  Scheduler scheduler(run.threads());
  Threads runtime(scheduler);
  const auto work = [&] { return choose(run, init, runtime); };
  run.verify("not the seeds of the calling thread",
             [&] { return work() == choose(run, init, reference_runtime()); });
  run.measure(work);
  rate_seeds(run);
}

}  // namespace

void add_seeds_benchmarks(const BenchMesh& mesh) {
  for (const auto& [name, init] : inits) {
    const std::string stage = std::string("seeds/") + name;
    add_benchmark(stage, mesh, {mesh.usual_seeds, Setting::sequential, {}},
                  [init = init](Run& run) { choose_sequentially(run, init); });
    for (const std::size_t threads : thread_ladder()) {
      add_benchmark(stage, mesh, {mesh.usual_seeds, threads, {}},
                    [init = init](Run& run) { choose_in_parallel(run, init); });
    }
  }
}

}  // namespace geolloyd
