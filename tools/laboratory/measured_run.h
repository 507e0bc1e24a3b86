#pragma once

#include <cstdint>
#include <vector>

#include "core/lloyd/relaxation.h"
#include "geolloyd/runtime.h"
#include "parallel/threads/scheduler.h"
#include "tools/words/names.h"

namespace geolloyd {

/// A relaxation, how long it took, and the most memory the process held meanwhile.
struct MeasuredRun {
  Relaxation relaxation;
  double seconds = 0;
  std::uint64_t peak_memory_bytes = 0;
};

/// Makes a new engine and relaxes with it; both count as time.
MeasuredRun measure_run(const Graph& graph, std::vector<NodeId> seeds,
                        const RelaxationOptions& options, const ProgressCallback& observer,
                        Runtime& runtime);

}  // namespace geolloyd
