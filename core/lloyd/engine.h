#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/base/kernel_seconds.h"
#include "core/voronoi/energy.h"
#include "core/voronoi/partition.h"

namespace geolloyd {

/// One microstep of the precise phase, over all regions.
struct Microstep {
  std::uint32_t seeds_moved = 0;
  std::uint64_t node_visits =
      0;  ///< nodes that the definition searches, however few an engine does

  friend bool operator==(const Microstep&, const Microstep&) = default;
};

/// Per region: where its seed stands after each of its moves of one macrostep, in their order;
/// nothing where it stays. The n-th microstep makes the n-th move of each.
using SeedTrails = std::vector<std::vector<NodeId>>;

struct MacrostepOptions {
  std::span<const std::uint8_t> keeps_seed;  ///< per region: not 0 where the seed must stay
  bool extended = true;                      ///< heuristic of the extended mode
  bool microstep_skip = true;                ///< do not search a region again whose seed stayed
  SeedTrails* trails = nullptr;              ///< null: not wanted
};

/// The coarse kernels the Lloyd loop (relaxation.h) is made of. Engines differ in how they work,
/// never in what comes out.
class Engine {
 public:
  Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  virtual ~Engine() = default;

  /// Partition of all nodes, regions free. `seeds` are different nodes.
  virtual void partition(std::span<const NodeId> seeds) = 0;

  /// Of the last partition():
  [[nodiscard]] virtual std::span<const Score> region_scores() const = 0;
  [[nodiscard]] virtual std::uint64_t state_digest(std::span<const NodeId> seeds) const = 0;
  /// One greedy_candidate per region (seed_move.h).
  virtual std::vector<NodeId> greedy_candidates(std::span<const NodeId> seeds, bool extended) = 0;

  /// Told, now and then and by the calling thread, how many seeds are still moving; false asks the
  /// engine to leave the macrostep, with the seeds wherever they are.
  using KeepGoing = std::function<bool(std::uint32_t seeds_moving)>;
  /// Locks the regions of the last partition() and moves `seeds` until none moves any more. The
  /// first microstep needs no search: with the seeds of a free partition, locking changes no key.
  virtual std::vector<Microstep> macrostep(std::vector<NodeId>& seeds,
                                           const MacrostepOptions& options,
                                           const KeepGoing& keep_going) = 0;

  /// Result of the last partition(); spoilt by a macrostep that leaves a seed elsewhere.
  [[nodiscard]] virtual const Partition& current() const = 0;
  /// Time spent so far; `other` is the caller's to fill.
  [[nodiscard]] virtual const KernelSeconds& seconds() const = 0;
};

/// The partition of `seeds`, which lives until the engine works again.
inline const Partition& partition_of(Engine& engine, std::span<const NodeId> seeds) {
  engine.partition(seeds);
  return engine.current();
}

}  // namespace geolloyd
