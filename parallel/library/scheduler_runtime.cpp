#include "parallel/library/scheduler_runtime.h"

#include "parallel/engine/parallel_engine.h"
#include "parallel/engine/parallel_growing_search.h"
#include "parallel/surface/parallel_surface_engine.h"

namespace geolloyd {

std::unique_ptr<Engine> SchedulerRuntime::make_engine(const Graph& graph) {
  return make_parallel_engine(scheduler_, graph);
}

std::unique_ptr<GrowingSearch> SchedulerRuntime::make_growing_search(const Graph& graph) {
  return make_parallel_growing_search(scheduler_, graph);
}

std::unique_ptr<SurfaceEngine> SchedulerRuntime::make_surface_engine(const FineMesh& mesh) {
  return make_parallel_surface_engine(mesh, scheduler_);
}

}  // namespace geolloyd
