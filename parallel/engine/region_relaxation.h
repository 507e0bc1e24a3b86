#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/base/stopwatch.h"
#include "core/lloyd/engine.h"
#include "core/lloyd/seed_move.h"
#include "parallel/engine/large_region_search.h"
#include "parallel/engine/local_region.h"
#include "parallel/engine/neighbour_subtrees.h"
#include "parallel/engine/simd_search.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {

/// Moves one seed within its locked region until it rests: all microsteps of a macrostep of that
/// region, which needs nothing from outside. The course is the reference engine's, move by move,
/// but most of its searches are never made:
///
/// * What a node's score is depends on the region and the node alone. The seed mostly goes to a
///   neighbour, finds it no better, and comes back; back, nothing is new.
/// * Such a visit asks for the score only. Subtree sums are needed where the seed has no lower
///   neighbour: there it becomes the *current seed*, whose other neighbours are *candidates*.
/// * The seed will want the scores of most candidates. They are found together (simd_search.h), but
///   in large regions one by one: lanes of many nodes leave the cache, and the seed mostly goes on
///   to the first.
///
/// One per thread; the memory is reused.
class RegionRelaxation {
 public:
  struct Outcome {
    NodeId seed;          ///< where it rests, in the whole graph
    std::uint32_t moves;  ///< of the reference engine
  };

  /// `goes_on` is asked before each move; once it returns false the work ends.
  explicit RegionRelaxation(const std::function<bool()>& goes_on) : goes_on_(goes_on) {}

  /// Takes a copy of a region (local_region.h), to work on with all threads of `shared`, or alone
  /// where that is null.
  void gather(const Graph& graph, const std::vector<Key>& keys, std::span<const NodeId> nodes,
              std::vector<NodeId>& local_of, Scheduler* shared);
  /// Of the region gathered last, from `seed`, whose keys and score these are. If it may not go on
  /// until the seed rests, that is anywhere. Adds to `trail`, unless that is null, where the seed
  /// is after each move.
  Outcome relax(NodeId seed, Score score, bool extended, std::vector<NodeId>* trail);
  /// Writes back the keys of where the seed is now; other threads may be reading those of others.
  void scatter_keys(RegionId region, std::vector<Key>& keys);

  /// Time spent in here since this was last asked; an estimate, for the shares of kernels in it.
  KernelSeconds take_seconds() {
    small_regions_ = 0;
    return std::exchange(seconds_, {});
  }

 private:
  // A neighbour of the current seed without a score, and how promising it is.
  struct Candidate {
    Uint128 heuristic;
    NodeId node;
  };

  double weight_of_time(std::size_t nodes, const Scheduler* shared);
  void begin(NodeId seed, Score score);
  void settle_at(NodeId node);
  void move_keys_to(NodeId node);
  void find_sums();
  void weigh_neighbours();
  NodeId best_candidate();
  Score score_of(NodeId node);
  template <class DistanceFrom>
  void rule_out(Score score, const DistanceFrom& distance);
  void look_ahead(NodeId node);
  void search_large(NodeId source);
  void search_from_sources();
  void find_order();
  void offset_lane(std::size_t lane);

  const std::function<bool()>& goes_on_;
  Scheduler alone_{1};  // of large regions that are not shared
  bool extended_ = true;
  LocalRegion local_;
  std::uint64_t mass_ = 0;  // of all nodes

  // By local node:
  std::vector<Score> score_;  // of those that have been the seed
  std::vector<Score> ahead_;  // of those that may come to be; never_scored - 1: too high
  std::vector<NodeId> all_;   // 0, 1, 2...

  // The current seed, its candidates, best first, and by local node the branches and sums.
  NodeId current_ = no_id;
  std::vector<Candidate> candidates_;
  std::size_t first_candidate_ = 0;  // all before have scores
  BranchOf branch_of_;
  SubtreeSums sums_;

  std::unique_ptr<LargeRegionSearch> large_;  // null where lanes search
  SimdSearch lanes_;
  std::vector<NodeId> sources_;  // of the lanes; none where these are not of the current seed

  // Room for work.
  std::vector<NodeId> order_;
  std::vector<NodeId> bucket_;
  std::vector<BranchSum> branch_sums_;
  std::vector<SimdSearch::Lanes> offset_;
  std::vector<std::uint8_t> below_;
  KernelSeconds seconds_;
  Laps laps_;
  std::size_t small_regions_ = 0;  // since the time was last asked
};

}  // namespace geolloyd
