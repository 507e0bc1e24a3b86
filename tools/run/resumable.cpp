#include "tools/run/resumable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <utility>

#include "geolloyd/errors.h"
#include "tools/files/output_folder.h"
#include "tools/run/frames.h"
#include "tools/system/interrupt.h"
#include "tools/words/names.h"

namespace geolloyd {

ResumableRelaxation::ResumableRelaxation(const RelaxArguments& arguments, const Start& start)
    : arguments_(arguments),
      start_(start),
      file_(checkpoint_path(arguments.output), start.mesh_graph.graph, start.seeds,
            relaxation_options(arguments.start.seeds, arguments.relaxation)) {
  if (arguments.resume) {
    Checkpoint checkpoint = file_.read();
    resumed_ = {checkpoint.state.steps.size(), checkpoint.seconds};
    state_ = std::move(checkpoint.state);
  } else {
    state_.seeds = start.seeds;
  }
}

EndedRelaxation ResumableRelaxation::relax(Scheduler& scheduler, ProgressLine& progress) {
  watch_ = since_saved_ = Stopwatch();
  const Graph& graph = start_.mesh_graph.graph;
  const EngineKind kind = arguments_.engine.kind;
  EndedRelaxation ended;
  ended.threads = kind == EngineKind::reference ? 1 : scheduler.threads();
  ended.engine = make_engine(kind, arguments_.engine.frontier, scheduler, graph);
  std::optional<FramesEngine> frames;
  if (!arguments_.frames.empty()) {
    frames.emplace(*ended.engine, arguments_, start_, scheduler, state_.steps);
  }
  const bool keeps_course = !arguments_.page_file.empty();
  const std::size_t earlier_steps = state_.steps.size();
  if (keeps_course) ended.course.push_back(state_.seeds);
  Engine& chosen = frames ? static_cast<Engine&>(*frames) : *ended.engine;
  ended.relaxation = geolloyd::relax(
      graph, chosen, state_, relaxation_options(arguments_.start.seeds, arguments_.relaxation),
      [&](const Progress& p) {
        progress.show(p, start_.seeds.size());
        return !interrupted();
      },
      [&](const RelaxationState& state) {
        if (keeps_course) ended.course.push_back(state.seeds);
        if (since_saved_.seconds() >= arguments_.checkpoint_seconds) save(progress);
      });
  if (keeps_course) {  // after the last step there was none
    ended.course.resize(
        std::min(ended.course.size(), ended.relaxation.steps.size() - earlier_steps));
  }
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
