#include <benchmark/benchmark.h>

#include <cstdio>
#include <exception>
#include <vector>

#include "bench/suites/suites.h"
#include "bench/support/arguments.h"
#include "bench/support/bench_mesh.h"
#include "bench/support/interrupt.h"
#include "bench/support/run.h"
#include "geolloyd/errors.h"

namespace {

using geolloyd::Arguments;
using geolloyd::BenchMesh;

constexpr int status_failed = 1;
constexpr int status_bad_input = 2;  // the user's to mend
constexpr int status_interrupted = 130;

std::vector<BenchMesh> given_meshes(const Arguments& arguments) {
  std::vector<BenchMesh> meshes;
  for (const auto& file : arguments.meshes) {
    meshes.push_back(geolloyd::mesh_of_file(file, arguments.seeds));
  }
  return meshes;
}

// Those that are not too small for the seeds; the largest is always there, if only to say so.
std::vector<BenchMesh> generated_meshes(const Arguments& arguments) {
  constexpr std::size_t largest = 1'000'000;
  std::vector<BenchMesh> meshes;
  for (const std::size_t triangles : {std::size_t{10'000}, std::size_t{100'000}, largest}) {
    if (triangles != largest && arguments.seeds.value_or(1) > triangles / 2) continue;
    meshes.push_back(geolloyd::generated_mesh(triangles, arguments.seeds));
  }
  return meshes;
}

// Mesh by mesh, as only the last one is kept.
void add_all(const std::vector<BenchMesh>& meshes) {
  for (const BenchMesh& mesh : meshes) {
    geolloyd::add_load_benchmarks(mesh);
    geolloyd::add_graph_benchmarks(mesh);
    geolloyd::add_seeds_benchmarks(mesh);
    geolloyd::add_partition_benchmarks(mesh);
    geolloyd::add_region_benchmarks(mesh);
    geolloyd::add_relaxation_benchmarks(mesh);
    geolloyd::add_surface_benchmarks(mesh);
  }
}

int run(int argc, char** argv) {
  const Arguments arguments = geolloyd::take_arguments(argc, argv);
  if (arguments.help) geolloyd::print_help();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return status_bad_input;
  geolloyd::watch_for_interrupts();
  add_all(arguments.meshes.empty() ? generated_meshes(arguments) : given_meshes(arguments));
  if (benchmark::RunSpecifiedBenchmarks() == 0) return status_bad_input;  // it has said why
  if (geolloyd::was_interrupted()) return status_interrupted;
  return geolloyd::any_benchmark_failed() ? status_failed : 0;
}

int complain(int status, const char* message) {
  std::fprintf(stderr, "geolloyd_bench: %s\n", message);
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const geolloyd::Error& error) {
    return complain(status_bad_input, error.what());
  } catch (const std::exception& error) {
    return complain(status_failed, error.what());
  }
}
