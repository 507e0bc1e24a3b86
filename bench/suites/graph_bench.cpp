// From a mesh to its graphs, by one thread and by several.
#include <string>
#include <utility>

#include "bench/suites/suites.h"
#include "bench/support/run.h"
#include "bench/support/same_bytes.h"
#include "core/graph/mesh_graph.h"
#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_edges.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {
namespace {

constexpr std::pair<const char*, GraphKind> kinds[] = {
    {"vertex", GraphKind::vertex},     {"vertex-dense", GraphKind::vertex_dense},
    {"triangle", GraphKind::triangle}, {"triangle-dense", GraphKind::triangle_dense},
    {"mixed", GraphKind::mixed},       {"vertex-far", GraphKind::vertex_far},
};

template <class Work, class Expected>
void measure_same_bytes(Run& run, Work&& work, const Expected& expected) {
  run.verify("not the bytes of the calling thread", [&] { return same_bytes(work(), expected); });
  run.measure(work);
}

template <class Find>
void measure_edges(Run& run, Find&& find) {
  measure_same_bytes(run, find, run.inputs().edges());
  run.rate("triangles/s", run.inputs().mesh().triangle_count());
}

template <class Check>
void measure_check(Run& run, Check&& check) {
  measure_same_bytes(run, check, run.inputs().facts());
  run.rate("triangles/s", run.inputs().mesh().triangle_count());
}

std::size_t bytes_of(const Graph& graph) {
  return graph.first_arc.size() * sizeof(ArcId) + graph.target.size() * sizeof(NodeId) +
         graph.length.size() * sizeof(std::uint32_t) + graph.mass.size() * sizeof(std::uint32_t);
}

template <class Make>
void measure_graph(Run& run, GraphKind kind, Make&& make) {
  const MeshGraph& expected = run.inputs().mesh_graph(kind);
  measure_same_bytes(run, make, expected);
  run.rate_of_graph(expected.graph);
  run.count("graph_bytes", bytes_of(expected.graph));
}

void add_sequential(const BenchMesh& mesh) {
  add_benchmark("edges", mesh, {}, [](Run& run) {
    Inputs& in = run.inputs();
    measure_edges(run, [&] { return find_edges(in.mesh()); });
  });
  add_benchmark("check", mesh, {}, [](Run& run) {
    Inputs& in = run.inputs();
    measure_check(run, [&] { return check_mesh(in.mesh(), in.edges()); });
  });
  for (const auto& [name, kind] : kinds) {
    add_benchmark(std::string("graph/") + name, mesh, {}, [kind = kind](Run& run) {
      Inputs& in = run.inputs();
      const MeshGraphOptions options{kind, Norm::geodesic, {}};
      measure_graph(run, kind, [&] { return make_mesh_graph(in.mesh(), in.edges(), options); });
    });
  }
}

void add_parallel(const BenchMesh& mesh, std::size_t threads) {
  const Setting setting{0, threads, {}};
  add_benchmark("edges", mesh, setting, [](Run& run) {
    Inputs& in = run.inputs();
    Scheduler scheduler(run.threads());
    measure_edges(run, [&] { return find_edges(in.mesh(), scheduler); });
  });
  add_benchmark("check", mesh, setting, [](Run& run) {
    Inputs& in = run.inputs();
    Scheduler scheduler(run.threads());
    measure_check(run, [&] { return check_mesh(in.mesh(), in.edges(), scheduler); });
  });
  for (const auto& [name, kind] : kinds) {
    add_benchmark(std::string("graph/") + name, mesh, setting, [kind = kind](Run& run) {
      Inputs& in = run.inputs();
      Scheduler scheduler(run.threads());
      const MeshGraphOptions options{kind, Norm::geodesic, {}};
      measure_graph(run, kind,
                    [&] { return make_mesh_graph(in.mesh(), in.edges(), options, scheduler); });
    });
  }
}

}  // namespace

void add_graph_benchmarks(const BenchMesh& mesh) {
  add_sequential(mesh);
  for (const std::size_t threads : thread_ladder()) add_parallel(mesh, threads);
}

}  // namespace geolloyd
