#include "bench/support/run.h"

#include <exception>
#include <utility>

namespace geolloyd {
namespace {

bool some_failed = false;

std::string name_of(const std::string& stage, const BenchMesh& mesh, const Setting& setting) {
  std::string name = stage + "/" + mesh.name;
  if (setting.seeds != 0) name += "/seeds:" + std::to_string(setting.seeds);
  name += setting.threads == Setting::sequential ? "/sequential"
                                                 : "/threads:" + std::to_string(setting.threads);
  if (!setting.more.empty()) name += "/" + setting.more;
  return name;
}

}  // namespace

void Run::rate(const char* what, std::size_t per_turn) {
  state_.counters[what] = benchmark::Counter(static_cast<double>(per_turn),
                                             benchmark::Counter::kIsIterationInvariantRate);
}

void Run::count(const char* what, std::size_t per_turn) {
  state_.counters[what] = static_cast<double>(per_turn);
}

void Run::bytes(std::size_t per_turn) {
  state_.SetBytesProcessed(state_.iterations() * static_cast<std::int64_t>(per_turn));
}

void Run::rate_of_graph(const Graph& graph) {
  rate("nodes/s", graph.node_count());
  rate("arcs/s", graph.arc_count());
}

void Run::fail(const std::string& complaint) {
  failed_ = true;
  some_failed = true;
  state_.SkipWithError(complaint.c_str());
}

void add_benchmark(const std::string& stage, const BenchMesh& mesh, const Setting& setting,
                   std::function<void(Run&)> body) {
  const auto call = [mesh, setting, body = std::move(body),
                     is_verified = false](benchmark::State& state) mutable {
    Run run(state, mesh, setting, is_verified);
    try {
      leave_if_interrupted();
      body(run);
    } catch (const Interrupted&) {
      state.SkipWithError("interrupted");
    } catch (const std::exception& error) {
      run.fail(error.what());
    }
    is_verified = !run.failed();
  };
  // NOLINTNEXTLINE(clang-analyzer-cplusplus.NewDeleteLeaks): Google Benchmark keeps it
  benchmark::RegisterBenchmark(name_of(stage, mesh, setting).c_str(), call)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

bool any_benchmark_failed() {
  return some_failed;
}

}  // namespace geolloyd
