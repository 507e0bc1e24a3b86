// Whole relaxations, with the thesis's settings.
#include <string>

#include "bench/suites/suites.h"
#include "bench/support/frontiers.h"
#include "bench/support/run.h"
#include "core/lloyd/reference_engine.h"
#include "parallel/engine/parallel_engine.h"

namespace geolloyd {
namespace {

const std::vector<NodeId>& first_seeds(Run& run) {
  return run.inputs().solved(run.seeds()).seeds;
}

void count_steps(Run& run, const Relaxed& relaxed) {
  run.rate("node visits/s", relaxed.node_visits);
  run.count("steps", relaxed.steps);
}

// Verified when its result was made, once for all: on a large mesh it takes a minute.
void relax_by_reference(Run& run) {
  const Graph& graph = run.inputs().graph();
  const Relaxed& verified = run.inputs().relaxed(run.seeds());
  run.measure([&] { return relax(graph, *make_reference_engine(graph), first_seeds(run), {}); });
  count_steps(run, verified);
}

void relax_in_parallel(Run& run, Frontier frontier) {
  const Graph& graph = run.inputs().graph();
  const Relaxed& expected = run.inputs().relaxed(run.seeds());
  Scheduler scheduler(run.threads());
  const auto work = [&] {
    const auto engine = make_parallel_engine(scheduler, graph, frontier);
    return relax(graph, *engine, first_seeds(run), {});
  };
  run.verify("not the course of the reference", [&] { return summarise(work()) == expected; });
  run.measure(work);
  count_steps(run, expected);
}

}  // namespace

void add_relaxation_benchmarks(const BenchMesh& mesh) {
  constexpr std::size_t most_nodes_from_scratch = 100'000;  // beyond, half a minute each and more
  add_benchmark("relaxation/reference", mesh, {mesh.usual_seeds, Setting::sequential, {}},
                relax_by_reference);
  for (const std::size_t threads : thread_ladder()) {
    const Setting setting{mesh.usual_seeds, threads, {}};
    add_benchmark("relaxation/automatic", mesh, setting,
                  [](Run& run) { relax_in_parallel(run, Frontier::automatic); });
    if (mesh.nodes > most_nodes_from_scratch) continue;
    for (const auto& [name, frontier] : frontiers) {
      add_benchmark(std::string("relaxation/") + name, mesh, setting,
                    [frontier = frontier](Run& run) { relax_in_parallel(run, frontier); });
    }
  }
}

}  // namespace geolloyd
