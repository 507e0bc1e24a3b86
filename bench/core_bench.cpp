// The stages of a run, one by one, each verified before it is timed. On a generated mesh of a
// million triangles, or on the file that GEOLLOYD_BENCH_MESH names.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/check_partition.h"
#include "core/dijkstra.h"
#include "core/forest.h"
#include "core/mesh_check.h"
#include "core/mesh_graph.h"
#include "core/mesh_io.h"
#include "core/reference_engine.h"
#include "core/relaxation.h"
#include "core/seeds.h"
#include "core/shapes.h"
#include "core/subtree.h"

namespace geolloyd {
namespace {

const Mesh& bench_mesh() {
  static const Mesh mesh = [] {
    const char* file = std::getenv("GEOLLOYD_BENCH_MESH");
    return file != nullptr ? read_mesh(file).mesh : creature(1'000'000, 1);
  }();
  return mesh;
}

const MeshEdges& bench_edges() {
  static const MeshEdges edges = find_edges(bench_mesh());
  return edges;
}

const MeshGraph& bench_graph() {
  static const MeshGraph made = make_mesh_graph(bench_mesh(), bench_edges(), {});
  return made;
}

std::vector<NodeId> bench_seeds(std::size_t count) {
  const Graph& graph = bench_graph().graph;
  return choose_seeds(graph, connected_components(graph), SeedInit::random_area, count, 1);
}

void count_items(benchmark::State& state, const char* what, std::size_t per_iteration) {
  state.counters[what] = benchmark::Counter(
      static_cast<double>(per_iteration) * static_cast<double>(state.iterations()),
      benchmark::Counter::kIsRate);
}

void read_file_of_kind(benchmark::State& state, const char* extension) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / (std::string("geolloyd-bench") + extension);
  write_mesh(path, bench_mesh());
  if (read_mesh(path).mesh.triangle_count() != bench_mesh().triangle_count()) {
    state.SkipWithError("the mesh read is not the mesh written");
  }
  for ([[maybe_unused]] const auto& turn : state) {
    benchmark::DoNotOptimize(read_mesh(path).mesh.positions.data());
  }
  count_items(state, "triangles/s", bench_mesh().triangle_count());
  std::filesystem::remove(path);
}
BENCHMARK_CAPTURE(read_file_of_kind, ply, ".ply")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(read_file_of_kind, obj, ".obj")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(read_file_of_kind, off, ".off")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(read_file_of_kind, stl, ".stl")->Unit(benchmark::kMillisecond)->UseRealTime();

void find_and_check_edges(benchmark::State& state) {
  for ([[maybe_unused]] const auto& turn : state) {
    const MeshEdges edges = find_edges(bench_mesh());
    benchmark::DoNotOptimize(check_mesh(bench_mesh(), edges));
  }
  count_items(state, "triangles/s", bench_mesh().triangle_count());
}
BENCHMARK(find_and_check_edges)->Unit(benchmark::kMillisecond)->UseRealTime();

void build_graph(benchmark::State& state, GraphKind kind) {
  MeshGraphOptions options;
  options.kind = kind;
  std::size_t arcs = 0;
  for ([[maybe_unused]] const auto& turn : state) {
    arcs = make_mesh_graph(bench_mesh(), bench_edges(), options).graph.arc_count();
  }
  count_items(state, "arcs/s", arcs);
}
BENCHMARK_CAPTURE(build_graph, vertex, GraphKind::vertex)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(build_graph, vertex_dense, GraphKind::vertex_dense)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(build_graph, triangle, GraphKind::triangle)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(build_graph, triangle_dense, GraphKind::triangle_dense)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(build_graph, mixed, GraphKind::mixed)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void choose_first_seeds(benchmark::State& state, SeedInit init) {
  const Graph& graph = bench_graph().graph;
  const Components components = connected_components(graph);
  for ([[maybe_unused]] const auto& turn : state) {
    benchmark::DoNotOptimize(choose_seeds(graph, components, init, 2048, 1).data());
  }
}
BENCHMARK_CAPTURE(choose_first_seeds, farthest, SeedInit::farthest)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(choose_first_seeds, kmeans_plus_plus, SeedInit::kmeans_plus_plus)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// Keys and parents, regions free.
void partition(benchmark::State& state) {
  const Graph& graph = bench_graph().graph;
  const std::vector<NodeId> seeds = bench_seeds(static_cast<std::size_t>(state.range(0)));
  IndexedHeap heap(graph.node_count());
  Partition result;
  std::vector<NodeId> settled;
  const auto search = [&] {
    search_free(graph, seeds, heap, result.key, settled);
    result.parent.assign(graph.node_count(), no_id);
    derive_parents(graph, result.key, settled, result.parent);
  };
  search();
  if (check_partition(graph, seeds, result, Regions::free)) state.SkipWithError("not a partition");
  for ([[maybe_unused]] const auto& turn : state) search();
  count_items(state, "nodes/s", graph.node_count());
}
BENCHMARK(partition)
    ->RangeMultiplier(8)
    ->Range(4, 32768)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// One macrostep of the reference engine from fresh seeds; the counter is what the locked searches
// settle.
void macrostep(benchmark::State& state) {
  const Graph& graph = bench_graph().graph;
  const std::vector<NodeId> start = bench_seeds(2048);
  const auto engine = make_reference_engine(graph);
  const std::vector<std::uint8_t> keeps_seed(start.size(), 0);
  std::size_t visits = 0;
  for ([[maybe_unused]] const auto& turn : state) {
    state.PauseTiming();
    std::vector<NodeId> seeds = start;
    engine->partition(seeds);
    state.ResumeTiming();
    const auto microsteps =
        engine->macrostep(seeds, {keeps_seed, true, true}, [](std::uint32_t) { return true; });
    for (const Microstep& m : microsteps) visits += m.node_visits;
  }
  state.counters["node visits/s"] =
      benchmark::Counter(static_cast<double>(visits), benchmark::Counter::kIsRate);
}
BENCHMARK(macrostep)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace geolloyd

BENCHMARK_MAIN();
