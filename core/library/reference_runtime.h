#pragma once

#include "core/base/executor.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

/// The sequential reference engines. Stages that are loops, as those between a mesh and its graph,
/// run on `executor`, which must live on.
class ReferenceRuntime final : public Runtime {
 public:
  explicit ReferenceRuntime(Executor& executor) : executor_(executor) {}

  Executor& executor() override { return executor_; }
  std::unique_ptr<Engine> make_engine(const Graph& graph) override;
  std::unique_ptr<GrowingSearch> make_growing_search(const Graph& graph) override;
  std::unique_ptr<SurfaceEngine> make_surface_engine(const FineMesh& mesh) override;

 private:
  Executor& executor_;
};

}  // namespace geolloyd
