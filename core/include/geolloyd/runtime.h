#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geolloyd/types.h"

namespace geolloyd {

class Engine;
class Executor;
class GrowingSearch;
class SurfaceEngine;
struct FineMesh;
struct Graph;

/// Who computes: threads by the parallel engines (Threads, geolloyd/threads.h), or the calling
/// thread by the sequential reference engines. A result is the same to the bit with every runtime;
/// only the time differs. One thread at a time may use a runtime.
class Runtime {
 public:
  Runtime() = default;
  Runtime(const Runtime&) = delete;
  Runtime& operator=(const Runtime&) = delete;
  virtual ~Runtime() = default;

  // For the library. Engines and searches refer to the graph or mesh, and to this.
  virtual Executor& executor() = 0;
  virtual std::unique_ptr<Engine> make_engine(const Graph& graph) = 0;
  virtual std::unique_ptr<GrowingSearch> make_growing_search(const Graph& graph) = 0;
  virtual std::unique_ptr<SurfaceEngine> make_surface_engine(const FineMesh& mesh) = 0;
};

/// All threads that this process may use: the default of every function. It is the calling thread's
/// own, so several threads may compute at once; no thread hands it to another. In
/// geolloyd::parallel; who links geolloyd::core alone passes reference_runtime().
Runtime& all_threads();

/// The calling thread alone: the sequential reference. It is simple, and many times slower. It has
/// no state.
Runtime& reference_runtime();

}  // namespace geolloyd
