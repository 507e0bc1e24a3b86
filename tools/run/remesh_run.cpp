#include "tools/run/remesh_run.h"

#include <algorithm>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/course/remesh_warnings.h"
#include "tools/evaluation/attribute_transfer.h"
#include "tools/evaluation/tolerance_search.h"
#include "tools/run/stages.h"

namespace geolloyd {
namespace {

void make(const RemeshRequest& request, const MeshFacts& facts, RemeshCourse course,
          RemeshResult& result) {
  if (request.tolerance > 0) {
    const double unit = request.is_percentage ? facts.bounding_diagonal / 100 : 1;
    ToleranceSearch found = search_within(request.tolerance * unit, std::move(course));
    result.made = std::move(found.best);
    if (!found.trials.empty()) result.bounds = found.bounds;
    result.trials = std::move(found.trials);
  } else {
    result.made = run(std::move(course));
  }
}

}  // namespace

RemeshedInput remesh_input(const RemeshRequest& request, const std::optional<PictureLook>& picture,
                           EngineKind engine, const MemoryCheck& check_memory, Scheduler& scheduler,
                           ProgressLine& progress) {
  const auto runtime = make_runtime(engine, Frontier::automatic, scheduler);
  RemeshedInput done;
  RemeshResult& result = done.result;
  result.workers = {engine, scheduler.backend(),
                    engine == EngineKind::reference ? 1 : scheduler.threads()};
  done.loaded = load_surface(request, scheduler, progress);
  const Input& input = done.loaded.input;
  MeshEdges& edges = done.loaded.edges;
  RemeshOptions options = read_options(request, done.loaded, scheduler);
  done.field = options.field;
  const auto budget = [&](std::uint64_t bytes) {
    check_memory(bytes);
    result.memory_estimate = std::max(result.memory_estimate, bytes);
  };
  RemeshCourse course =
      remesh_course(done.loaded, std::move(options), *runtime, progress, budget, picture);
  if (!(request.tolerance > 0)) {
    course.release_edges = [&edges] { release_all_but_duplicates(edges); };
  }
  make(request, input.facts, std::move(course), result);

  progress.stage("carrying properties over");
  const Properties none;
  result.properties =
      transfer_properties(input.mesh(), request.carries_properties ? input.loaded.properties : none,
                          result.made.remesh, scheduler);

  progress.stage("measuring the remesh");
  const Stopwatch judging;
  result.figures =
      judge_remesh(input.mesh(), edges, input.facts, result.made.remesh, done.field, scheduler);
  if (result.figures.distance) {
    warn_of_distance(result.figures.distance->largest, input.facts.bounding_diagonal,
                     result.made.remesh);
  }
  result.judge_seconds = judging.seconds();
  return done;
}

}  // namespace geolloyd
