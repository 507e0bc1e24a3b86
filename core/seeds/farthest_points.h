#pragma once

#include <span>
#include <vector>

#include "core/base/executor.h"
#include "core/graph/graph.h"
#include "core/seeds/farthest_trial.h"
#include "core/seeds/nearest_distances.h"

namespace geolloyd {

/// Farthest points of a graph (Gonzalez 1985), component by component.
class FarthestPoints {
 public:
  FarthestPoints(const Graph& graph, Executor& executor);

  /// `count` nodes of a component, one after the other: each is the farthest from `first` and all
  /// before it, the smallest of equals. `nodes` are all of the component, ascending; `first` are
  /// some of them, at least one, and there are at least `count` others.
  std::vector<NodeId> choose(std::span<const NodeId> nodes, std::span<const NodeId> first,
                             std::size_t count);

 private:
  // What one thread at a time tries. Chosen nodes have the distance at which they were chosen.
  struct Part {
    FarthestTrial trial;
    std::vector<NodeDistance> chosen{};
    std::vector<NodeDistance> lowered{};
  };

  [[nodiscard]] NodeDistance chosen_now(NodeId node) const {
    return {node, nearest_.values()[node]};
  }
  std::vector<NodeId> candidates(std::size_t count);
  std::vector<NodeId> only_farthest_around(const std::vector<NodeId>& peaks, std::uint32_t above);
  void keep_farthest(std::size_t count, std::vector<NodeId>& nodes) const;
  void choose_farthest(std::span<const NodeId> candidates);
  void choose_certain(std::span<const NodeId> candidates);
  template <class Visit>
  void for_parts(std::span<const NodeId> nodes, Visit&& visit);

  const Graph& graph_;
  Executor& executor_;
  NearestDistances nearest_;
  std::vector<Part> parts_;
  std::vector<NodeDistance> chosen_;
};

}  // namespace geolloyd
