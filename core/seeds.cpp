#include "core/seeds.h"

#include <algorithm>
#include <queue>
#include <span>
#include <string>
#include <utility>

#include "core/errors.h"
#include "core/indexed_heap.h"
#include "core/partition.h"
#include "core/random.h"
#include "core/weighted_sampler.h"

namespace geolloyd {
namespace {

/// Distances to the nearest of a growing set of seeds.
class GrowingSearch {
 public:
  explicit GrowingSearch(const Graph& graph)
      : graph_(graph),
        heap_(graph.node_count()),
        distance_(graph.node_count(), unreached_distance) {}

  [[nodiscard]] std::uint32_t distance(NodeId v) const { return distance_[v]; }

  /// Adds a seed and visits each node that is nearer to it than to those before.
  template <class Visit>
  void add(NodeId seed, Visit&& visit) {
    distance_[seed] = 0;
    heap_.push_or_decrease(seed, 0);
    while (!heap_.empty()) {
      const NodeId v = heap_.pop();
      visit(v);
      for (ArcId a = graph_.first_arc[v]; a < graph_.first_arc[v + 1]; ++a) {
        const NodeId u = graph_.target[a];
        const std::uint32_t offered = distance_[v] + graph_.length[a];
        if (offered >= distance_[u]) continue;
        distance_[u] = offered;
        heap_.push_or_decrease(u, offered);
      }
    }
  }

 private:
  const Graph& graph_;
  IndexedHeap heap_;
  std::vector<std::uint32_t> distance_;
};

class SeedChooser {
 public:
  SeedChooser(const Graph& graph, std::uint64_t random_seed)
      : graph_(graph),
        random_seed_(random_seed),
        search_(graph),
        sampler_(graph.node_count()),
        is_chosen_(graph.node_count(), false) {}

  // The nodes with the smallest random numbers: any order of looking gives the same.
  void choose_random(std::span<const NodeId> nodes, std::size_t count) {
    std::vector<std::pair<std::uint64_t, NodeId>> drawn;
    for (const NodeId v : nodes) {
      if (!is_chosen_[v]) drawn.emplace_back(random_bits(random_seed_, v), v);
    }
    const auto end = drawn.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(drawn.begin(), end, drawn.end());
    for (auto d = drawn.begin(); d != end; ++d) choose(d->second);
  }

  void choose_by_area(std::span<const NodeId> nodes, std::size_t count) {
    for (const NodeId v : nodes) sampler_.set(v, graph_.mass[v]);
    for (; count > 0 && sampler_.total() > 0; --count) {
      choose(draw());
      sampler_.set(chosen_.back(), 0);
    }
    forget_weights(nodes);
    choose_random(nodes, count);
  }

  void choose_farthest(std::span<const NodeId> nodes, std::size_t count) {
    choose_random(nodes, 1);
    search_.add(chosen_.back(), [](NodeId) {});
    // Largest distance first, then smallest node. Entries may be out of date, but only too far: a
    // distance never grows.
    using Entry = std::pair<std::uint32_t, NodeId>;
    std::vector<Entry> entries;
    entries.reserve(nodes.size());
    for (const NodeId v : nodes) entries.emplace_back(search_.distance(v), ~v);
    std::priority_queue farthest(std::less<>(), std::move(entries));
    for (--count; count > 0;) {
      const auto [distance, complement] = farthest.top();
      const NodeId v = ~complement;
      farthest.pop();
      if (search_.distance(v) != distance) {
        farthest.emplace(search_.distance(v), complement);
        continue;
      }
      choose(v);
      search_.add(v, [](NodeId) {});
      --count;
    }
  }

  void choose_plus_plus(std::span<const NodeId> nodes, std::size_t count) {
    const auto update = [this](NodeId v) {
      const std::uint64_t distance = search_.distance(v);
      const std::uint64_t squared = distance * distance;
      sampler_.set(v, Uint128{squared} * graph_.mass[v]);
    };
    choose_by_area(nodes, 1);
    search_.add(chosen_.back(), update);
    for (--count; count > 0 && sampler_.total() > 0; --count) {
      choose(draw());
      search_.add(chosen_.back(), update);
    }
    forget_weights(nodes);
    choose_random(nodes, count);
  }

  std::vector<NodeId> take() { return std::move(chosen_); }

 private:
  void choose(NodeId v) {
    is_chosen_[v] = true;
    chosen_.push_back(v);
  }

  NodeId draw() {
    const Uint128 place = random_below(random_seed_, draws_++, sampler_.total());
    return static_cast<NodeId>(sampler_.at(place));
  }

  void forget_weights(std::span<const NodeId> nodes) {
    for (const NodeId v : nodes) sampler_.set(v, 0);
  }

  const Graph& graph_;
  std::uint64_t random_seed_;
  std::uint64_t draws_ = 0;
  GrowingSearch search_;
  WeightedSampler sampler_;  // per node; all weights 0 between components
  std::vector<bool> is_chosen_;
  std::vector<NodeId> chosen_;
};

// How many seeds each component gets.
std::vector<std::size_t> share_out(const Graph& graph, const Components& components,
                                   std::size_t count) {
  struct Share {
    std::uint64_t mass;
    std::size_t seeds;
    std::size_t component;
    bool operator<(const Share& other) const {  // less mass per seed, then later component
      const Uint128 mine = Uint128{mass} * other.seeds;
      const Uint128 others = Uint128{other.mass} * seeds;
      return mine != others ? mine < others : component > other.component;
    }
  };
  std::priority_queue<Share> shares;
  std::vector<std::size_t> seeds(components.size(), 1);
  const auto offer = [&](std::size_t c, std::uint64_t mass) {
    if (seeds[c] < components.nodes(c).size()) shares.push({mass, seeds[c], c});
  };
  for (std::size_t c = 0; c < components.size(); ++c) {
    std::uint64_t mass = 0;
    for (const NodeId v : components.nodes(c)) mass += graph.mass[v];
    offer(c, mass);
  }
  for (std::size_t left = count - components.size(); left > 0; --left) {
    const Share most = shares.top();
    shares.pop();
    ++seeds[most.component];
    offer(most.component, most.mass);
  }
  return seeds;
}

void check_count(const Graph& graph, const Components& components, std::size_t count) {
  if (count < components.size()) {
    throw InvalidInput("the graph has " + std::to_string(components.size()) +
                       " connected components, and each needs a seed: ask for at least " +
                       std::to_string(components.size()) + " seeds instead of " +
                       std::to_string(count));
  }
  if (count > graph.node_count()) {
    throw InvalidInput("more seeds (" + std::to_string(count) + ") than graph nodes (" +
                       std::to_string(graph.node_count()) +
                       "): ask for fewer seeds, or subdivide the mesh");
  }
}

}  // namespace

std::vector<NodeId> choose_seeds(const Graph& graph, const Components& components, SeedInit init,
                                 std::size_t count, std::uint64_t random_seed) {
  check_count(graph, components, count);
  const std::vector<std::size_t> share = share_out(graph, components, count);
  SeedChooser chooser(graph, random_seed);
  for (std::size_t c = 0; c < components.size(); ++c) {
    const std::span<const NodeId> nodes = components.nodes(c);
    switch (init) {
      case SeedInit::random:
        chooser.choose_random(nodes, share[c]);
        break;
      case SeedInit::random_area:
        chooser.choose_by_area(nodes, share[c]);
        break;
      case SeedInit::farthest:
        chooser.choose_farthest(nodes, share[c]);
        break;
      case SeedInit::kmeans_plus_plus:
        chooser.choose_plus_plus(nodes, share[c]);
        break;
    }
  }
  return chooser.take();
}

}  // namespace geolloyd
