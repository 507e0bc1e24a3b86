#pragma once

#include <memory>

#include "geolloyd/runtime.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {

/// The threads of a scheduler, which must live on, with the parallel engine.
class SchedulerRuntime final : public Runtime {
 public:
  explicit SchedulerRuntime(Scheduler& scheduler) : scheduler_(scheduler) {}

  Executor& executor() override { return scheduler_; }
  std::unique_ptr<Engine> make_engine(const Graph& graph) override;
  std::unique_ptr<GrowingSearch> make_growing_search(const Graph& graph) override;
  std::unique_ptr<SurfaceEngine> make_surface_engine(const FineMesh& mesh) override;

 private:
  Scheduler& scheduler_;
};

}  // namespace geolloyd
