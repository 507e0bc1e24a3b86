#include "tools/laboratory/measured_run.h"

#include <utility>

#include "core/base/stopwatch.h"
#include "tools/system/machine.h"

namespace geolloyd {

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
