// Does the work of each stage once, on a small mesh and by one thread, and prints how much that is:
// lines of stage, counter and value. tests/work/work_guard compares them with what is on record,
// and runs this under valgrind where it can, to count instructions too. What is 0 is not printed.
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>

#include "core/graph/components.h"
#include "core/graph/mesh_graph.h"
#include "core/lloyd/reference_engine.h"
#include "core/lloyd/relaxation.h"
#include "core/mesh/mesh_edges.h"
#include "core/seeds/seeds.h"
#include "core/shapes/shapes.h"
#include "parallel/engine/parallel_engine.h"
#include "parallel/threads/scheduler.h"
#include "tests/support/counted_new.h"

#if GEOLLOYD_CALLGRIND
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_START_INSTRUMENTATION
#define CALLGRIND_DUMP_STATS_AT(name) static_cast<void>(name)
#define CALLGRIND_STOP_INSTRUMENTATION
#endif

namespace geolloyd {
namespace {

constexpr std::size_t many_seeds = 128;
constexpr std::size_t few_seeds = 4;

struct Work {
  Allocations allocated;
  std::uint64_t node_visits = 0;
};

// Returns the node visits of the definition, 0 where it says nothing of them.
using Stage = std::function<std::uint64_t()>;

Work work_of(const std::string& name, const Stage& stage) {
  const Allocations before = allocations();
  CALLGRIND_START_INSTRUMENTATION;
  const std::uint64_t node_visits = stage();
  CALLGRIND_DUMP_STATS_AT(name.c_str());
  CALLGRIND_STOP_INSTRUMENTATION;
  const Allocations after = allocations();
  return {{after.count - before.count, after.bytes - before.bytes}, node_visits};
}

void print(const std::string& stage, const char* counter, std::uint64_t value) {
  if (value == 0) return;
  std::printf("%s %s %llu\n", stage.c_str(), counter, static_cast<unsigned long long>(value));
}

void measure(const std::string& name, const Stage& stage) {
  const Work work = work_of(name, stage);
  print(name, "node_visits", work.node_visits);
  print(name, "allocations", work.allocated.count);
  print(name, "bytes", work.allocated.bytes);
}

std::uint64_t visits_of_relaxation(const Graph& graph, Engine& engine,
                                   const std::vector<NodeId>& seeds) {
  std::uint64_t visits = 0;
  for (const Step& step : relax(graph, engine, seeds, {}).steps) visits += step.node_visits;
  return visits;
}

MeshGraph build_graphs(Scheduler& scheduler) {
  const Mesh mesh = creature(20'000, 1);
  MeshGraph made;
  measure("graph/sequential", [&] {
    made = make_mesh_graph(mesh, find_edges(mesh), {});
    return 0;
  });
  measure("graph/parallel", [&] {
    made = make_mesh_graph(mesh, find_edges(mesh, scheduler), {}, scheduler);
    return 0;
  });
  return made;
}

void choose_farthest(Scheduler& scheduler, const Graph& graph, const Components& components) {
  measure("farthest_seeds/sequential", [&] {
    choose_seeds(graph, components, SeedInit::farthest, many_seeds, 1);
    return 0;
  });
  measure("farthest_seeds/parallel", [&] {
    Threads runtime(scheduler);
    choose_seeds(graph, components, SeedInit::farthest, many_seeds, 1, runtime);
    return 0;
  });
}

// What a relaxation is made of, once each: small kernels would hide in it.
void run_kernels(const std::string& name, Engine& engine, std::vector<NodeId> seeds) {
  measure("partition/" + name, [&] {
    engine.partition(seeds);
    return 0;
  });
  measure("greedy_candidates/" + name, [&] {
    engine.greedy_candidates(seeds, true);
    return 0;
  });
  const std::vector<std::uint8_t> keeps_seed(seeds.size(), 0);
  measure("macrostep/" + name, [&] {
    std::uint64_t visits = 0;
    for (const Microstep& m :
         engine.macrostep(seeds, {keeps_seed, true, true}, [](std::uint32_t) { return true; })) {
      visits += m.node_visits;
    }
    return visits;
  });
  measure("repair/" + name, [&] {
    engine.partition(seeds);
    return 0;
  });
}

void relax_all(Scheduler& scheduler, const Graph& graph, const Components& components) {
  const auto seeds = [&](std::size_t count) {
    return choose_seeds(graph, components, SeedInit::random_area, count, 1);
  };
  const std::vector<NodeId> many = seeds(many_seeds);
  const std::vector<NodeId> few = seeds(few_seeds);
  run_kernels("reference", *make_reference_engine(graph), many);
  run_kernels("parallel", *make_parallel_engine(scheduler, graph), many);
  measure("relaxation/reference",
          [&] { return visits_of_relaxation(graph, *make_reference_engine(graph), many); });
  measure("relaxation/parallel", [&] {
    return visits_of_relaxation(graph, *make_parallel_engine(scheduler, graph), many);
  });
  measure("relaxation/parallel_few_seeds", [&] {
    return visits_of_relaxation(graph, *make_parallel_engine(scheduler, graph), few);
  });
}

// What the number of instructions depends on, besides the work.
std::string code_running() {
#if defined(__clang__)
  std::string code = "Clang " + std::to_string(__clang_major__);
#else
  std::string code = "GCC " + std::to_string(__GNUC__);
#endif
#if defined(__GLIBC__)
  code += ", glibc " + std::to_string(__GLIBC__) + "." + std::to_string(__GLIBC_MINOR__);
#endif
#if defined(__x86_64__)
  code += __builtin_cpu_supports("avx2") != 0 ? ", x86-64, AVX2" : ", x86-64, no AVX2";
#else
  code += ", not x86-64";
#endif
  return code;
}

void run_stages() {
  std::printf("# instructions: %s\n", code_running().c_str());
  Scheduler scheduler(1);
  const MeshGraph made = build_graphs(scheduler);
  const Components components = connected_components(made.graph);
  choose_farthest(scheduler, made.graph, components);
  relax_all(scheduler, made.graph, components);
}

}  // namespace
}  // namespace geolloyd

int main() {
  geolloyd::run_stages();
}
