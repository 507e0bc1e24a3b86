#pragma once

#include <memory>

#include "core/lloyd/engine.h"
#include "core/surface/cells/paired_surface_engine.h"
#include "core/voronoi/growing_search.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

/// Surface engines in pairs, one of each runtime, that are compared all the time; all else as the
/// tested one has it. All three must live on.
class PairedSurfaces final : public Runtime {
 public:
  PairedSurfaces(Runtime& expected, Runtime& tested, SurfaceComparison& comparison)
      : expected_(expected), tested_(tested), comparison_(comparison) {}

  Executor& executor() override { return tested_.executor(); }
  std::unique_ptr<Engine> make_engine(const Graph& graph) override {
    return tested_.make_engine(graph);
  }
  std::unique_ptr<GrowingSearch> make_growing_search(const Graph& graph) override {
    return tested_.make_growing_search(graph);
  }
  std::unique_ptr<SurfaceEngine> make_surface_engine(const FineMesh& mesh) override {
    return std::make_unique<PairedSurfaceEngine>(expected_.make_surface_engine(mesh),
                                                 tested_.make_surface_engine(mesh), comparison_);
  }

 private:
  Runtime& expected_;
  Runtime& tested_;
  SurfaceComparison& comparison_;
};

}  // namespace geolloyd
