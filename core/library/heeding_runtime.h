#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "core/base/heeding_executor.h"
#include "core/lloyd/engine.h"
#include "core/surface/cells/surface_engine.h"
#include "core/voronoi/growing_search.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

/// Another runtime whose stages heed one watch more; its engines do not, as their steps are short.
class HeedingRuntime final : public Runtime {
 public:
  /// `runtime` must live on.
  HeedingRuntime(Runtime& runtime, std::function<void()> watch)
      : inner_(runtime), executor_(runtime.executor(), std::move(watch)) {}

  Executor& executor() override { return executor_; }
  std::unique_ptr<Engine> make_engine(const Graph& graph) override {
    return inner_.make_engine(graph);
  }
  std::unique_ptr<GrowingSearch> make_growing_search(const Graph& graph) override {
    return inner_.make_growing_search(graph);
  }
  std::unique_ptr<SurfaceEngine> make_surface_engine(const FineMesh& mesh) override {
    return inner_.make_surface_engine(mesh);
  }

 private:
  Runtime& inner_;
  HeedingExecutor executor_;
};

}  // namespace geolloyd
