#pragma once

#include <memory>
#include <vector>

#include "core/lloyd/relaxation.h"
#include "geolloyd/runtime.h"
#include "parallel/engine/parallel_engine.h"
#include "tools/words/names.h"

namespace geolloyd {

std::unique_ptr<Engine> make_engine(EngineKind kind, Frontier frontier, Scheduler& scheduler,
                                    const Graph& graph);

/// The engines that --engine and --frontier name, on these threads, which must live on.
std::unique_ptr<Runtime> make_runtime(EngineKind kind, Frontier frontier, Scheduler& scheduler);

/// A relaxation, how long it took, and the most memory the process held meanwhile.
struct MeasuredRun {
  Relaxation relaxation;
  double seconds = 0;
  std::uint64_t peak_memory_bytes = 0;
};

/// Makes a new engine and relaxes with it; both count as time.
MeasuredRun measure_run(EngineKind kind, Frontier frontier, Scheduler& scheduler,
                        const Graph& graph, std::vector<NodeId> seeds,
                        const RelaxationOptions& options, const ProgressCallback& observer);

}  // namespace geolloyd
