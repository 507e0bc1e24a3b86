#include "core/base/executor.h"
#include "core/lloyd/reference_engine.h"
#include "core/surface/cells/reference_surface_engine.h"
#include "core/voronoi/growing_search.h"
#include "geolloyd/runtime.h"

namespace geolloyd {
namespace {

class ReferenceRuntime final : public Runtime {
 public:
  Executor& executor() override { return sequential(); }
  std::unique_ptr<Engine> make_engine(const Graph& graph) override {
    return make_reference_engine(graph);
  }
  std::unique_ptr<GrowingSearch> make_growing_search(const Graph& graph) override {
    return geolloyd::make_growing_search(graph);
  }
  std::unique_ptr<SurfaceEngine> make_surface_engine(const FineMesh& mesh) override {
    return make_reference_surface_engine(mesh);
  }
};

}  // namespace

Runtime& reference_runtime() {
  static ReferenceRuntime runtime;
  return runtime;
}

}  // namespace geolloyd
