#pragma once

#include <cstddef>
#include <memory>

#include "geolloyd/runtime.h"

namespace geolloyd {

class Scheduler;

/// Whose threads do the work: oneTBB's or OpenMP's.
enum class Backend { tbb, openmp };

/// Each thread has memory of its own to work in.
inline constexpr std::size_t most_threads = 1024;

/// How the parallel engine finds regions when they are free. The result is the same.
enum class Frontier {
  heap,       ///< from scratch, by one thread (Dijkstra)
  delta,      ///< from scratch, by all (delta-stepping)
  regions,    ///< from the last ones, only where they change; at first like delta
  automatic,  ///< the fastest: so far that is regions in all cases measured
};

/// Threads of this machine, with the parallel engines. What they compute is what the sequential
/// reference computes, to the bit, however many they are.
class Threads final : public Runtime {
 public:
  /// At most most_threads; 0: as many as this process may use. Throws InvalidInput.
  explicit Threads(std::size_t count = 0, Backend backend = Backend::tbb,
                   Frontier frontier = Frontier::automatic);
  /// For the library: those of a scheduler, which must live on.
  explicit Threads(Scheduler& scheduler, Frontier frontier = Frontier::automatic);
  ~Threads() override;

  [[nodiscard]] std::size_t count() const;

  Executor& executor() override;
  std::unique_ptr<Engine> make_engine(const Graph& graph) override;
  std::unique_ptr<GrowingSearch> make_growing_search(const Graph& graph) override;
  std::unique_ptr<SurfaceEngine> make_surface_engine(const FineMesh& mesh) override;

 private:
  std::unique_ptr<Scheduler> own_;  // null: it is borrowed
  Scheduler& scheduler_;
  Frontier frontier_;
};

}  // namespace geolloyd
