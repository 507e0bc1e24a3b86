#pragma once

#include <vector>

#include "parallel/scheduler.h"
#include "tools/progress.h"
#include "tools/run_record.h"

namespace geolloyd {

/// The threads that the command line asks for.
Scheduler make_scheduler(const RelaxArguments& a);

/// All that comes before the relaxation: reads and checks the mesh, builds the graph, chooses or
/// reads the first seeds and returns them. Fills in what `run` has to say of these stages.
std::vector<NodeId> prepare(RunRecord& run, Scheduler& scheduler, ProgressLine& progress);

}  // namespace geolloyd
