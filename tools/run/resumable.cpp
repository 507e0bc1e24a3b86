#include "tools/run/resumable.h"

#include <fmt/format.h>

#include <cstdio>
#include <optional>
#include <utility>

#include "core/base/errors.h"
#include "tools/files/output_folder.h"
#include "tools/run/frames.h"
#include "tools/run/measured_run.h"
#include "tools/system/interrupt.h"
#include "tools/words/names.h"

namespace geolloyd {

ResumableRelaxation::ResumableRelaxation(RunRecord& run, std::vector<NodeId> first_seeds)
    : run_(run),
      first_seeds_(std::move(first_seeds)),
      file_(checkpoint_path(run.arguments.output), run.mesh_graph.graph, first_seeds_,
            relaxation_options(run.arguments)) {
  if (run.arguments.resume) {
    Checkpoint checkpoint = file_.read();
    run.resumed = {checkpoint.state.steps.size(), checkpoint.seconds};
    earlier_seconds_ = checkpoint.seconds;
    state_ = std::move(checkpoint.state);
  } else {
    state_.seeds = first_seeds_;
  }
}

std::unique_ptr<Engine> ResumableRelaxation::relax(Scheduler& scheduler, ProgressLine& progress) {
  watch_ = since_saved_ = Stopwatch();
  const RelaxArguments& a = run_.arguments;
  const Graph& graph = run_.mesh_graph.graph;
  const EngineKind kind = value_of(engine_names, a.engine);
  run_.threads = kind == EngineKind::reference ? 1 : scheduler.threads();
  auto engine = make_engine(kind, value_of(frontier_names, a.frontier), scheduler, graph);
  std::optional<FramesEngine> frames;
  if (!a.frames.empty()) frames.emplace(*engine, run_, scheduler, first_seeds_, state_.steps);
  Engine& chosen = frames ? static_cast<Engine&>(*frames) : *engine;
  run_.relaxation = geolloyd::relax(
      graph, chosen, state_, relaxation_options(a),
      [&](const Progress& p) {
        progress.show(p, first_seeds_.size());
        return !interrupted();
      },
      [&](const RelaxationState&) {
        if (since_saved_.seconds() >= a.checkpoint_seconds) save(progress);
      });
  run_.seconds.relax = watch_.seconds();
  return engine;
}

bool ResumableRelaxation::save(ProgressLine& progress) {
  since_saved_ = Stopwatch();
  try {
    file_.write({state_, earlier_seconds_ + watch_.seconds()});
    return true;
  } catch (const IoError& error) {
    progress.clear();
    fmt::print(stderr, "geolloyd: without a checkpoint: {}\n", error.what());
    return false;
  }
}

void ResumableRelaxation::forget() {
  remove_file(file_.path());
}

}  // namespace geolloyd
