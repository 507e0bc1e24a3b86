#include "tools/run/measured_run.h"

#include <utility>

#include "core/base/stopwatch.h"
#include "core/library/reference_runtime.h"
#include "tools/system/machine.h"

namespace geolloyd {

std::unique_ptr<Runtime> make_runtime(EngineKind kind, Frontier frontier, Scheduler& scheduler) {
  if (kind == EngineKind::reference) return std::make_unique<ReferenceRuntime>(scheduler);
  return std::make_unique<Threads>(scheduler, frontier);
}

MeasuredRun measure_run(const Graph& graph, std::vector<NodeId> seeds,
                        const RelaxationOptions& options, const ProgressCallback& observer,
                        Runtime& runtime) {
  forget_peak_memory();
  MeasuredRun run;
  const Stopwatch watch;
  const auto engine = runtime.make_engine(graph);
  run.relaxation = relax(graph, *engine, std::move(seeds), options, observer);
  run.seconds = watch.seconds();
  run.peak_memory_bytes = peak_memory_bytes();
  return run;
}

}  // namespace geolloyd
