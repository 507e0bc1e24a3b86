#include "geolloyd/threads.h"

#include <string>

#include "geolloyd/errors.h"
#include "parallel/engine/parallel_engine.h"
#include "parallel/engine/parallel_growing_search.h"
#include "parallel/surface/parallel_surface_engine.h"
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
  return make_parallel_engine(*scheduler_, graph);
}

std::unique_ptr<GrowingSearch> Threads::make_growing_search(const Graph& graph) {
  return make_parallel_growing_search(*scheduler_, graph);
}

std::unique_ptr<SurfaceEngine> Threads::make_surface_engine(const FineMesh& mesh) {
  return make_parallel_surface_engine(mesh, *scheduler_);
}

}  // namespace geolloyd
