#include "tools/run/tolerance_search.h"

#include <utility>

namespace geolloyd {

ToleranceSearch search_within(double tolerance, const LoadedInput& loaded,
                              const std::function<TimedRemesh(std::size_t vertices)>& make,
                              Scheduler& scheduler, ProgressLine& progress) {
  const Mesh& mesh = loaded.input.mesh();
  VertexSearch search(tolerance, most_vertices_to_try(mesh));
  TimedRemesh best;
  while (const auto vertices = search.next()) {
    TimedRemesh made = make(*vertices);
    progress.stage("measuring the remesh");
    const bool is_interrupted = made.remesh.interrupted;
    if (search.add(measure_trial(mesh, loaded.input.facts.bounding_diagonal, made.remesh.mesh,
                                 scheduler))) {
      best = std::move(made);
    }
    if (!is_interrupted) continue;
    best.remesh.interrupted = true;
    break;
  }
  return {std::move(best), search.trials()};
}

}  // namespace geolloyd
