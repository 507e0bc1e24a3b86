#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "bench/support/inputs.h"
#include "bench/support/interrupt.h"
#include "core/base/stopwatch.h"

namespace geolloyd {

/// What a benchmark's name says after its stage and mesh.
struct Setting {
  static constexpr std::size_t sequential = 0;

  std::size_t seeds = 0;             ///< 0: has none
  std::size_t threads = sequential;  ///< or core's function, which knows of no threads
  std::string more;
};

/// One call of a benchmark's body. Google Benchmark makes several, until it knows how many turns
/// take long enough.
class Run {
 public:
  Run(benchmark::State& state, const BenchMesh& mesh, const Setting& setting, bool is_verified)
      : state_(state), mesh_(mesh), setting_(setting), is_verified_(is_verified) {}

  [[nodiscard]] Inputs& inputs() const { return inputs_of(mesh_); }
  [[nodiscard]] std::size_t seeds() const { return setting_.seeds; }
  [[nodiscard]] std::size_t threads() const { return setting_.threads; }

  /// Where is_right() is false the benchmark fails and times nothing. Asked in the first call only.
  template <class IsRight>
  void verify(const char* complaint, IsRight&& is_right) {
    if (!is_verified_ && !is_right()) fail(complaint);
  }

  /// Times work() alone; neither prepare(), called before each turn, nor the end of what work()
  /// returns.
  template <class Prepare, class Work>
  void measure(Prepare&& prepare, Work&& work) {
    for ([[maybe_unused]] const auto& turn : state_) {
      leave_if_interrupted();
      prepare();
      const Stopwatch watch;
      if constexpr (std::is_void_v<std::invoke_result_t<Work&>>) {
        work();
        state_.SetIterationTime(watch.seconds());
      } else {
        auto result = work();
        state_.SetIterationTime(watch.seconds());
        benchmark::DoNotOptimize(result);
      }
    }
  }
  template <class Work>
  void measure(Work&& work) {
    measure([] {}, work);
  }

  /// Of a turn: how much of `what` per second, and simply how much.
  void rate(const char* what, std::size_t per_turn);
  void count(const char* what, std::size_t per_turn);
  void bytes(std::size_t per_turn);
  /// Nodes and arcs per second.
  void rate_of_graph(const Graph& graph);

  void fail(const std::string& complaint);
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  benchmark::State& state_;
  const BenchMesh& mesh_;
  const Setting& setting_;
  bool is_verified_;
  bool failed_ = false;
};

/// Registers `stage`/`mesh`/`setting`.
void add_benchmark(const std::string& stage, const BenchMesh& mesh, const Setting& setting,
                   std::function<void(Run&)> body);

/// Whether any benchmark has failed so far.
bool any_benchmark_failed();

}  // namespace geolloyd
