#include "geolloyd/threads.h"

#include <string>

#include "core/lloyd/engine.h"
#include "core/surface/cells/surface_engine.h"
#include "core/voronoi/growing_search.h"
#include "geolloyd/errors.h"
#include "parallel/library/scheduler_runtime.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {

Threads::Threads(std::size_t count, Backend backend) {
  if (count > most_threads) {
    throw InvalidInput("threads: " + std::to_string(count) + ": at most " +
                       std::to_string(most_threads));
  }
  scheduler_ = std::make_unique<Scheduler>(count, backend);
}

Threads::~Threads() = default;

std::size_t Threads::count() const {
  return scheduler_->threads();
}

Executor& Threads::executor() {
  return *scheduler_;
}

std::unique_ptr<Engine> Threads::make_engine(const Graph& graph) {
  return SchedulerRuntime(*scheduler_).make_engine(graph);
}

std::unique_ptr<GrowingSearch> Threads::make_growing_search(const Graph& graph) {
  return SchedulerRuntime(*scheduler_).make_growing_search(graph);
}

std::unique_ptr<SurfaceEngine> Threads::make_surface_engine(const FineMesh& mesh) {
  return SchedulerRuntime(*scheduler_).make_surface_engine(mesh);
}

}  // namespace geolloyd
