#include "tools/run/resumable.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "geolloyd/errors.h"
#include "tools/files/output_folder.h"
#include "tools/system/interrupt.h"

namespace geolloyd {

ResumableRelaxation::ResumableRelaxation(const PreparedRun& run, const RelaxationOptions& options,
                                         const CheckpointPlan& plan)
    : run_(run),
      options_(options),
      seconds_between_(plan.seconds),
      file_(checkpoint_path(plan.folder), run.mesh_graph.graph, run.seeds, options) {
  if (plan.begins_it) {
    Checkpoint checkpoint = file_.read();
    resumed_ = {checkpoint.state.steps.size(), checkpoint.seconds};
    state_ = std::move(checkpoint.state);
  } else {
    state_.seeds = run.seeds;
  }
}

EndedRelaxation ResumableRelaxation::relax(Runtime& runtime, ProgressLine& progress,
                                           const StepStartCallback& beginning) {
  watch_ = since_saved_ = Stopwatch();
  const Graph& graph = run_.mesh_graph.graph;
  EndedRelaxation ended;
  ended.engine = runtime.make_engine(graph);
  ended.relaxation = geolloyd::relax(
      graph, *ended.engine, state_, options_,
      [&](const Progress& p) {
        progress.show(p, run_.seeds.size());
        return !interrupted();
      },
      [&](const RelaxationState&) {
        if (since_saved_.seconds() >= seconds_between_) save(progress);
      },
      beginning);
  ended.seconds = watch_.seconds();
  return ended;
}

bool ResumableRelaxation::save(ProgressLine& progress) {
  since_saved_ = Stopwatch();
  try {
    file_.write({state_, (resumed_ ? resumed_->seconds : 0) + watch_.seconds()});
    return true;
  } catch (const IoError& error) {
    progress.clear();
    // Not fmt::print, which throws where the terminal has gone.
    std::fputs(fmt::format("geolloyd: without a checkpoint: {}\n", error.what()).c_str(), stderr);
    return false;
  }
}

void ResumableRelaxation::forget() {
  remove_file(file_.path());
}

}  // namespace geolloyd
