#include "core/seeds/seeds.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <queue>
#include <span>
#include <string>
#include <utility>

#include "core/base/random.h"
#include "core/base/weighted_sampler.h"
#include "core/seeds/farthest_points.h"
#include "core/voronoi/energy.h"
#include "core/voronoi/growing_search.h"
#include "core/voronoi/partition.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

class SeedChooser {
 public:
  SeedChooser(const Graph& graph, std::uint64_t random_seed, Runtime& runtime)
      : graph_(graph),
        random_seed_(random_seed),
        runtime_(runtime),
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
    if (!sampler_) sampler_.emplace(graph_.node_count());
    for (const NodeId v : nodes) sampler_->set(v, graph_.mass[v]);
    for (; count > 0 && sampler_->total() > 0; --count) {
      choose(draw());
      sampler_->set(chosen_.back(), 0);
    }
    forget_weights(nodes);
    choose_random(nodes, count);
  }

  void choose_farthest(std::span<const NodeId> nodes, std::size_t count) {
    choose_random(nodes, 1);
    const NodeId first = chosen_.back();
    choose_farthest_from({&first, 1}, nodes, count - 1);
  }

  // `given`, no more than `count`, then the farthest from them.
  void complete(std::span<const NodeId> given, std::span<const NodeId> nodes, std::size_t count) {
    if (given.empty()) return choose_farthest(nodes, count);
    for (const NodeId v : given) choose(v);
    choose_farthest_from(given, nodes, count - given.size());
  }

  void choose_plus_plus(std::span<const NodeId> nodes, std::size_t count) {
    if (!search_) search_ = runtime_.make_growing_search(graph_);
    choose_by_area(nodes, 1);
    weigh(search_->add(chosen_.back()));
    for (--count; count > 0 && sampler_->total() > 0; --count) {
      choose(draw());
      weigh(search_->add(chosen_.back()));
    }
    forget_weights(nodes);
    choose_random(nodes, count);
  }

  std::vector<NodeId> take() { return std::move(chosen_); }

 private:
  void choose_farthest_from(std::span<const NodeId> first, std::span<const NodeId> nodes,
                            std::size_t count) {
    if (count == 0) return;
    if (!farthest_) farthest_.emplace(graph_, runtime_.executor());
    for (const NodeId v : farthest_->choose(nodes, first, count)) choose(v);
  }

  void choose(NodeId v) {
    is_chosen_[v] = true;
    chosen_.push_back(v);
  }

  void weigh(std::span<const NodeId> nodes) {
    for (const NodeId v : nodes) {
      sampler_->set(v, node_score(distance_of(search_->keys()[v]), graph_.mass[v]));
    }
  }

  NodeId draw() {
    const Uint128 place = random_below(random_seed_, draws_++, sampler_->total());
    return static_cast<NodeId>(sampler_->at(place));
  }

  void forget_weights(std::span<const NodeId> nodes) {
    for (const NodeId v : nodes) sampler_->set(v, 0);
  }

  const Graph& graph_;
  std::uint64_t random_seed_;
  std::uint64_t draws_ = 0;
  Runtime& runtime_;
  std::unique_ptr<GrowingSearch> search_;
  std::optional<FarthestPoints> farthest_;
  std::optional<WeightedSampler> sampler_;  // per node; all weights 0 between components
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

// The node in the middle of each of `count` equal shares of the mass, or the next one that is free.
void spread_among(const Graph& graph, std::span<const NodeId> nodes, std::size_t count,
                  std::vector<NodeId>& places) {
  Uint128 whole = 0;
  for (const NodeId v : nodes) whole += graph.mass[v];
  Uint128 up_to = 0;
  std::size_t taken = 0;
  for (std::size_t i = 0; i < nodes.size() && taken < count; ++i) {
    up_to += graph.mass[nodes[i]];
    const bool is_due = Uint128{2} * count * up_to >= (Uint128{2} * taken + 1) * whole;
    if (!is_due && nodes.size() - i > count - taken) continue;
    places.push_back(nodes[i]);
    ++taken;
  }
}

}  // namespace

void check_seed_count(const Graph& graph, const Components& components, std::size_t count) {
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

std::vector<NodeId> choose_seeds(const Graph& graph, const Components& components, SeedInit init,
                                 std::size_t count, std::uint64_t random_seed, Runtime& runtime) {
  check_seed_count(graph, components, count);
  const std::vector<std::size_t> share = share_out(graph, components, count);
  SeedChooser chooser(graph, random_seed, runtime);
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
      case SeedInit::surface:
      case SeedInit::coarse:
      case SeedInit::automatic:
        chooser.choose_farthest(nodes, share[c]);
        break;
    }
  }
  return chooser.take();
}

std::vector<NodeId> complete_seeds(const Graph& graph, const Components& components,
                                   std::span<const NodeId> given, std::size_t count,
                                   std::uint64_t random_seed, Runtime& runtime) {
  check_seed_count(graph, components, count);
  const std::vector<std::size_t> share = share_out(graph, components, count);
  std::vector<std::vector<NodeId>> kept(components.size());
  for (const NodeId v : given) {
    const std::uint32_t c = components.component_of[v];
    if (kept[c].size() < share[c]) kept[c].push_back(v);
  }
  SeedChooser chooser(graph, random_seed, runtime);
  for (std::size_t c = 0; c < components.size(); ++c) {
    chooser.complete(kept[c], components.nodes(c), share[c]);
  }
  return chooser.take();
}

std::vector<NodeId> spread_nodes(const Graph& graph, const Components& components,
                                 std::size_t count) {
  const std::vector<std::size_t> share = share_out(graph, components, count);
  std::vector<NodeId> places;
  places.reserve(count);
  for (std::size_t c = 0; c < components.size(); ++c) {
    spread_among(graph, components.nodes(c), share[c], places);
  }
  std::sort(places.begin(), places.end());
  return places;
}

void check_every_component_has_a_seed(std::string_view name, const MeshGraph& mesh_graph,
                                      const Components& components, std::span<const NodeId> seeds) {
  std::vector<bool> has_seed(components.size(), false);
  for (const NodeId s : seeds) has_seed[components.component_of[s]] = true;
  const auto missing = std::find(has_seed.begin(), has_seed.end(), false);
  if (missing == has_seed.end()) return;
  const auto nodes = components.nodes(static_cast<std::size_t>(missing - has_seed.begin()));
  throw InvalidInput(std::string(name) + ": " +
                     std::to_string(std::count(has_seed.begin(), has_seed.end(), false)) + " of " +
                     std::to_string(components.size()) +
                     " connected components have no seed: add one to each, such as input id " +
                     std::to_string(mesh_graph.input_id[nodes.front()]));
}

}  // namespace geolloyd
