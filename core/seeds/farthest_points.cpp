#include "core/seeds/farthest_points.h"

#include <algorithm>

#include "core/base/loops.h"

namespace geolloyd {
namespace {

bool is_chosen_before(const NodeDistance& a, const NodeDistance& b) {
  return a.distance != b.distance ? a.distance > b.distance : a.node < b.node;
}

}  // namespace

FarthestPoints::FarthestPoints(const Graph& graph, Executor& executor)
    : graph_(graph), executor_(executor), nearest_(graph, executor) {}

// Nodes are chosen in the order of the distances that they have when they are. Distances only fall:
// so no node is chosen before one that is farther now. Say a node c would, if it were chosen now,
// lower no node that is farther than c. Then:
//
// * None of the nodes chosen before c lowers c. Such a node is farther than c, and nearer to c than
//   c is to those chosen, so c would lower it.
// * To choose c now changes none of them, as c lowers none of them.
//
// So c will be chosen, at the distance that it has now, and may lower others now. Several such
// nodes are found and chosen at once. The farthest of all always is one.
std::vector<NodeId> FarthestPoints::choose(std::span<const NodeId> nodes,
                                           std::span<const NodeId> first, std::size_t count) {
  constexpr std::size_t few_per_thread = 4;  // of which most are not certain
  if (count == 0) return {};
  nearest_.enter(nodes);
  nearest_.add(first);
  chosen_.clear();
  for (std::vector<NodeId> next = candidates(count); !next.empty(); next = candidates(count)) {
    if (next.size() > few_per_thread * executor_.threads()) {
      choose_certain(next);
    } else {
      choose_farthest(next);
    }
  }
  nearest_.leave();
  std::sort(chosen_.begin(), chosen_.end(), is_chosen_before);
  std::vector<NodeId> result(count);
  for (std::size_t i = 0; i < count; ++i) result[i] = chosen_[i].node;
  return result;
}

// The farthest node of all, and others about as far that may be certain, too; ascending. None where
// no node is left that comes before the last of `count`.
std::vector<NodeId> FarthestPoints::candidates(std::size_t count) {
  constexpr std::uint32_t share = 16;
  const std::uint32_t largest = nearest_.largest();
  if (largest == 0) return {};
  std::uint32_t above = largest - largest / share - 1;
  NodeDistance last{no_id, 0};
  if (chosen_.size() >= count) {
    const auto place = chosen_.begin() + static_cast<std::ptrdiff_t>(count - 1);
    std::nth_element(chosen_.begin(), place, chosen_.end(), is_chosen_before);
    last = *place;
    above = std::max(above, last.distance - 1);
  }
  std::vector<NodeId> found = nearest_.peaks_above(above);
  std::erase_if(found, [&](NodeId v) { return !is_chosen_before(chosen_now(v), last); });
  found = only_farthest_around(found, above);
  if (chosen_.size() < count) keep_farthest(count - chosen_.size(), found);
  return found;
}

// Distances are rough, so there are several peaks wherever nodes are far. One of them can be
// certain.
std::vector<NodeId> FarthestPoints::only_farthest_around(const std::vector<NodeId>& peaks,
                                                         std::uint32_t above) {
  if (peaks.size() <= 1) return peaks;
  for_parts(peaks, [&](Part& part, NodeId v) {
    if (part.trial.is_farthest_around(v, above)) part.chosen.push_back(chosen_now(v));
  });
  std::vector<NodeId> found;
  for (Part& part : parts_) {
    for (const NodeDistance& chosen : part.chosen) found.push_back(chosen.node);
    part.chosen.clear();
  }
  return found;
}

void FarthestPoints::keep_farthest(std::size_t count, std::vector<NodeId>& nodes) const {
  if (nodes.size() <= count) return;
  std::nth_element(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(count), nodes.end(),
                   [&](NodeId a, NodeId b) { return nearest_.is_farther(a, b); });
  nodes.resize(count);
  std::sort(nodes.begin(), nodes.end());
}

// All threads search from one node.
void FarthestPoints::choose_farthest(std::span<const NodeId> candidates) {
  const NodeId farthest =
      *std::min_element(candidates.begin(), candidates.end(),
                        [&](NodeId a, NodeId b) { return nearest_.is_farther(a, b); });
  chosen_.push_back(chosen_now(farthest));
  nearest_.add({&farthest, 1});
}

// Each thread searches from nodes of its own. Nothing is lowered before all have ended.
void FarthestPoints::choose_certain(std::span<const NodeId> candidates) {
  for_parts(candidates, [&](Part& part, NodeId v) {
    if (part.trial.search(v, part.lowered)) part.chosen.push_back(chosen_now(v));
  });
  parallel_for(executor_, parts_.size(), 1, [&](std::size_t p) {
    nearest_.lower(parts_[p].lowered);
    parts_[p].lowered.clear();
  });
  for (Part& part : parts_) {
    chosen_.insert(chosen_.end(), part.chosen.begin(), part.chosen.end());
    part.chosen.clear();
  }
}

// Calls visit(part, node) for all nodes. Those near in space are near in order: so a part has nodes
// near to each other, and its trial takes memory for their surroundings only.
template <class Visit>
void FarthestPoints::for_parts(std::span<const NodeId> nodes, Visit&& visit) {
  constexpr std::size_t parts_per_thread = 2;
  const std::size_t parts = std::min(parts_per_thread * executor_.threads(), nodes.size());
  while (parts_.size() < parts) parts_.push_back({FarthestTrial(graph_, nearest_)});
  parallel_for(executor_, parts, 1, [&](std::size_t p) {
    for (std::size_t i = nodes.size() * p / parts; i < nodes.size() * (p + 1) / parts; ++i) {
      visit(parts_[p], nodes[i]);
    }
  });
}

}  // namespace geolloyd
