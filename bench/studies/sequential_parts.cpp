// What share of each stage is done by one thread, however many there are, and how much faster than
// one thread the others can make it at most (Amdahl 1967):
// sequential_parts [TRIANGLES [SEEDS]] prints a table in Markdown.
//
// One thread plays the parts of 16, one after the other, so that the time within parallel loops and
// the time between them can be told apart on any machine. Uneven shares, waiting and the memory's
// bandwidth are not counted: real threads stay below the bound.
#include <charconv>
#include <cstdio>
#include <ctime>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "core/graph/components.h"
#include "core/graph/mesh_graph.h"
#include "core/lloyd/relaxation.h"
#include "core/mesh/mesh_check.h"
#include "core/regions/graph_dual.h"
#include "core/seeds/seeds.h"
#include "core/shapes/shapes.h"
#include "core/start/first_seeds.h"
#include "core/surface/result/remesh.h"
#include "parallel/engine/parallel_engine.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {
namespace {

constexpr std::size_t usual_triangles = 1'000'000;
constexpr std::size_t usual_seeds = 2048;
constexpr std::size_t players = 16;
constexpr std::uint64_t random_seed = 1;

// Of this process, which has one thread: others on the machine do not count.
double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

class OneByOne final : public Scheduler {
 public:
  OneByOne() : Scheduler(players, Backend::openmp) {}

  void run(std::size_t workers, const std::function<void(std::size_t worker)>& work) override {
    const double begin = processor_seconds();
    for (std::size_t worker = 0; worker < workers; ++worker) work(worker);
    seconds_in_loops_ += processor_seconds() - begin;
  }

  [[nodiscard]] double seconds_in_loops() const { return seconds_in_loops_; }

 private:
  double seconds_in_loops_ = 0;
};

class Table {
 public:
  explicit Table(const OneByOne& threads) : threads_(threads) {
    std::puts("| stage | seconds, one thread | sequential, % | at most, 16 threads | 64 threads |");
    std::puts("|---|---|---|---|---|");
  }

  template <class Stage>
  auto row(const char* name, Stage&& stage) {
    const double begin = processor_seconds();
    const double loops_begin = threads_.seconds_in_loops();
    auto result = stage();
    const double seconds = processor_seconds() - begin;
    const double share = 1 - (threads_.seconds_in_loops() - loops_begin) / seconds;
    const auto bound = [&](double threads) { return 1 / (share + (1 - share) / threads); };
    std::printf("| %s | %.2f | %.1f | %.1f | %.1f |\n", name, seconds, 100 * share, bound(16),
                bound(64));
    std::fflush(stdout);
    return result;
  }

 private:
  const OneByOne& threads_;
};

void print_relaxations(Table& table, OneByOne& threads, const Mesh& mesh, const MeshEdges& edges,
                       const MeshGraph& made, std::size_t seeds) {
  const Graph& graph = made.graph;
  Threads runtime(threads);
  const Components components =
      table.row("components", [&] { return connected_components(graph); });
  const auto choose = [&](SeedInit init, std::size_t count) {
    const FirstSeedOptions options{init, count};
    const std::vector<SeedPlace> places =
        find_first_places(mesh, edges.duplicates, graph.node_count(), options, runtime);
    return choose_first_seeds(mesh, places, made, components, options, runtime);
  };
  table.row("seeds, farthest", [&] { return choose(SeedInit::farthest, seeds); });
  table.row("seeds, coarse, 16", [&] { return choose(SeedInit::coarse, 16); });
  std::vector<NodeId> first =
      table.row("seeds, surface", [&] { return choose(SeedInit::surface, seeds); });

  const auto engine = make_parallel_engine(threads, graph);
  const auto from = [&](SeedInit init, std::size_t count, std::uint32_t most_greedy_steps) {
    RelaxationOptions options;
    options.max_greedy_steps = most_greedy_steps;
    options.max_macrosteps = 3;
    return relax(graph, *engine, choose(init, count), options);
  };
  table.row("relaxation, begun from 16 random seeds",
            [&] { return from(SeedInit::random_area, 16, 10); });
  table.row("relaxation, begun from random seeds",
            [&] { return from(SeedInit::random_area, seeds, 20); });
  const Relaxation relaxed = table.row("relaxation", [&] {
    RelaxationOptions options;
    options.greedy = GreedyMode::off;
    return relax(graph, *engine, std::move(first), options);
  });
  table.row("remesh of the relaxation", [&] {
    const Partition partition = partition_of(*engine, relaxed.seeds);
    return make_graph_dual({mesh, made, relaxed.seeds, partition, *engine, threads}, {});
  });
}

void print_table(std::size_t triangles, std::size_t seeds) {
  OneByOne threads;
  Table table(threads);
  const Mesh mesh = creature(triangles, random_seed);
  const MeshEdges edges = table.row("edges", [&] { return find_edges(mesh, threads); });
  table.row("checks", [&] { return check_mesh(mesh, edges, threads); });
  for (const auto& [name, kind] : {std::pair("graph, vertex", GraphKind::vertex),
                                   {"graph, vertex-dense", GraphKind::vertex_dense},
                                   {"graph, mixed", GraphKind::mixed}}) {
    table.row(name, [&, kind = kind] {
      return make_mesh_graph(mesh, edges, {kind, Norm::geodesic, {}}, threads);
    });
  }
  const MeshGraph made =
      make_mesh_graph(mesh, edges, {GraphKind::vertex, Norm::geodesic, {}}, threads);
  print_relaxations(table, threads, mesh, edges, made, seeds);
  Threads runtime(threads);
  table.row("surface remesh", [&] {
    RemeshOptions options;
    options.vertex_count = seeds;
    return make_remesh(mesh, edges, options, runtime);
  });
}

std::size_t number(std::string_view word) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || value == 0) {
    throw std::invalid_argument(std::string(word) + " is no number above 0");
  }
  return value;
}

}  // namespace
}  // namespace geolloyd

int main(int argc, char** argv) {
  try {
    geolloyd::print_table(argc > 1 ? geolloyd::number(argv[1]) : geolloyd::usual_triangles,
                          argc > 2 ? geolloyd::number(argv[2]) : geolloyd::usual_seeds);
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "sequential_parts: %s\n", e.what());
    return 2;
  }
}
