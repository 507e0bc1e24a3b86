#include "core/library/reference_runtime.h"

#include "core/lloyd/reference_engine.h"
#include "core/surface/cells/reference_surface_engine.h"
#include "core/voronoi/growing_search.h"

namespace geolloyd {

std::unique_ptr<Engine> ReferenceRuntime::make_engine(const Graph& graph) {
  return make_reference_engine(graph);
}

std::unique_ptr<GrowingSearch> ReferenceRuntime::make_growing_search(const Graph& graph) {
  return geolloyd::make_growing_search(graph);
}

std::unique_ptr<SurfaceEngine> ReferenceRuntime::make_surface_engine(const FineMesh& mesh) {
  return make_reference_surface_engine(mesh);
}

Runtime& reference_runtime() {
  static ReferenceRuntime runtime(sequential());
  return runtime;
}

}  // namespace geolloyd
