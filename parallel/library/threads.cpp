#include "geolloyd/threads.h"

#include <string>

#include "core/lloyd/engine.h"
#include "core/surface/cells/surface_engine.h"
#include "core/voronoi/growing_search.h"
#include "geolloyd/errors.h"
#include "parallel/engine/parallel_engine.h"
#include "parallel/engine/parallel_growing_search.h"
#include "parallel/surface/parallel_surface_engine.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {
namespace {

std::unique_ptr<Scheduler> make_scheduler(std::size_t count, Backend backend) {
  if (count > most_threads) {
    throw InvalidInput("threads: " + std::to_string(count) + ": at most " +
                       std::to_string(most_threads));
  }
  return std::make_unique<Scheduler>(count, backend);
}

}  // namespace

Threads::Threads(std::size_t count, Backend backend, Frontier frontier)
    : own_(make_scheduler(count, backend)), scheduler_(*own_), frontier_(frontier) {}

Threads::Threads(Scheduler& scheduler, Frontier frontier)
    : scheduler_(scheduler), frontier_(frontier) {}

Threads::~Threads() = default;

std::size_t Threads::count() const {
  return scheduler_.threads();
}

Executor& Threads::executor() {
  return scheduler_;
}

std::unique_ptr<Engine> Threads::make_engine(const Graph& graph) {
  return make_parallel_engine(scheduler_, graph, frontier_);
}

std::unique_ptr<GrowingSearch> Threads::make_growing_search(const Graph& graph) {
  return make_parallel_growing_search(scheduler_, graph);
}

std::unique_ptr<SurfaceEngine> Threads::make_surface_engine(const FineMesh& mesh) {
  return make_parallel_surface_engine(mesh, scheduler_);
}

Runtime& all_threads() {
  thread_local Threads threads;
  return threads;
}

}  // namespace geolloyd
