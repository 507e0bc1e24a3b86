#include "tools/run/measured_run.h"

#include <utility>

#include "core/base/stopwatch.h"
#include "core/library/reference_runtime.h"
#include "core/lloyd/reference_engine.h"
#include "parallel/library/scheduler_runtime.h"
#include "tools/system/machine.h"

namespace geolloyd {

std::unique_ptr<Engine> make_engine(EngineKind kind, Frontier frontier, Scheduler& scheduler,
                                    const Graph& graph) {
  return kind == EngineKind::reference ? make_reference_engine(graph)
                                       : make_parallel_engine(scheduler, graph, frontier);
}

std::unique_ptr<Runtime> make_runtime(EngineKind kind, Frontier, Scheduler& scheduler) {
  if (kind == EngineKind::reference) return std::make_unique<ReferenceRuntime>(scheduler);
  return std::make_unique<SchedulerRuntime>(scheduler);
}

MeasuredRun measure_run(EngineKind kind, Frontier frontier, Scheduler& scheduler,
                        const Graph& graph, std::vector<NodeId> seeds,
                        const RelaxationOptions& options, const ProgressCallback& observer) {
  forget_peak_memory();
  MeasuredRun run;
  const Stopwatch watch;
  const auto engine = make_engine(kind, frontier, scheduler, graph);
  run.relaxation = relax(graph, *engine, std::move(seeds), options, observer);
  run.seconds = watch.seconds();
  run.peak_memory_bytes = peak_memory_bytes();
  return run;
}

}  // namespace geolloyd
