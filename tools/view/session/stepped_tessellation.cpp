#include "tools/view/session/stepped_tessellation.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/voronoi/energy.h"
#include "geolloyd/errors.h"
#include "tools/run/seed_source.h"
#include "tools/system/memory_limit.h"

namespace geolloyd {
namespace {

bool same_choice(const SessionOptions& a, const SessionOptions& b) {
  return a.seeds.count == b.seeds.count && a.seeds.init == b.seeds.init &&
         a.seeds.random_seed == b.seeds.random_seed && a.seed_file.path == b.seed_file.path;
}

std::uint32_t count_steps_in(const std::vector<Step>& steps, Phase phase) {
  return static_cast<std::uint32_t>(std::count_if(
      steps.begin(), steps.end(), [phase](const Step& step) { return step.phase == phase; }));
}

// Regions that can be told apart, of nodes enough to move in.
std::size_t usual_seed_count(const Graph& graph, const Components& components) {
  constexpr std::size_t most = 256;
  constexpr std::size_t nodes_for_each = 20;
  return std::max(
      {std::size_t{1}, components.size(), std::min(most, graph.node_count() / nodes_for_each)});
}

// In each component.
bool has_seeds(const Components& components, const std::vector<NodeId>& seeds) {
  std::vector<bool> has_seed(components.size(), false);
  for (const NodeId s : seeds) has_seed[components.component_of[s]] = true;
  return std::find(has_seed.begin(), has_seed.end(), false) == has_seed.end();
}

// The same vertices or triangles in another graph; nothing where one of them has no node there.
std::optional<std::vector<NodeId>> carried(const MeshGraph& from, const std::vector<NodeId>& seeds,
                                           const MeshGraph& to) {
  std::vector<NodeId> nodes;
  nodes.reserve(seeds.size());
  for (const NodeId s : seeds) {
    const InputId id = from.input_id[s];
    if (from.is_triangle(id) != to.is_triangle(id) || id >= to.node_of.size() ||
        to.node_of[id] == no_id) {
      return std::nullopt;
    }
    nodes.push_back(to.node_of[id]);
  }
  return nodes;
}

}  // namespace

// All that depends on the graph and the choice of seeds, made before anything is replaced.
struct SteppedTessellation::Made {
  std::vector<TangentSpace> field;
  MeshGraph mesh_graph;
  Components components;
};

SteppedTessellation::SteppedTessellation(LoadedInput loaded, const SessionOptions& options,
                                         Runtime& runtime)
    : runtime_(runtime) {
  start_.load_seconds = loaded.seconds;
  start_.input = std::move(loaded.input);
  edges_ = std::move(loaded.edges);
  start_.surface = find_surface(start_.input.mesh(), edges_, runtime.executor());
  rebuild(options, true);
}

void SteppedTessellation::set(const SessionOptions& options) {
  rebuild(options, false);
}

void SteppedTessellation::choose_seeds() {
  rebuild(options_, true);
}

std::vector<NodeId> SteppedTessellation::choose(const SessionOptions& options, const Made* made) {
  SeedPlan plan = options.seeds;
  if (!options.seed_file.path.empty()) plan.given = seeds_of(options.seed_file);
  return find_first_seeds(start_.input.mesh(), edges_, made != nullptr ? made->field : field_,
                          made != nullptr ? made->mesh_graph : start_.mesh_graph,
                          made != nullptr ? made->components : components_, plan, runtime_)
      .nodes;
}

// Edited seeds stay where the choice of seeds does.
void SteppedTessellation::rebuild(SessionOptions options, bool chooses_anew) {
  const Mesh& mesh = start_.input.mesh();
  const bool is_new = !engine_ || options.graph != options_.graph;
  RunWork work;
  work.has_dual = true;
  const std::uint64_t bytes = estimate_memory(options.graph, options.seeds, start_.input, edges_,
                                              work, runtime_.executor());
  require_memory(start_.input.file.string(), bytes);
  std::optional<Made> made;
  if (is_new) {
    MeshGraphOptions asked = graph_options(options.graph, mesh, edges_, runtime_.executor());
    asked.welded_to = start_.input.loaded.welded_to;
    made.emplace();
    made->mesh_graph = make_mesh_graph(mesh, edges_, asked, runtime_.executor());
    made->field = std::move(asked.vertex_space);
    made->components = connected_components(made->mesh_graph.graph);
  }
  if (options.seeds.count == 0) {
    const MeshGraph& mesh_graph = made ? made->mesh_graph : start_.mesh_graph;
    options.seeds.count = usual_seed_count(mesh_graph.graph, made ? made->components : components_);
  }
  std::optional<std::vector<NodeId>> edited;
  if (has_edited_seeds_ && !chooses_anew && same_choice(options, options_)) {
    edited = made ? carried(start_.mesh_graph, start_.seeds, made->mesh_graph) : start_.seeds;
    if (edited && made && !has_seeds(made->components, *edited)) edited.reset();
  }
  std::vector<NodeId> first = edited ? *edited : choose(options, made ? &*made : nullptr);
  if (made) {
    engine_.reset();
    field_ = std::move(made->field);
    start_.mesh_graph = std::move(made->mesh_graph);
    components_ = std::move(made->components);
    engine_ = runtime_.make_engine(start_.mesh_graph.graph);
  }
  start_.components = components_.size();
  start_.memory_estimate = bytes;
  options_ = options;
  options_.seeds.count = first.size();
  begin(std::move(first), edited.has_value());
}

void SteppedTessellation::begin(std::vector<NodeId> first_seeds, bool are_edited) {
  start_.seeds = std::move(first_seeds);
  has_edited_seeds_ = are_edited;
  reset();
}

void SteppedTessellation::reset() {
  relaxation_options_ = {};
  relaxation_options_.greedy =
      greedy_mode(options_.greedy, !options_.seed_file.path.empty(), options_.seeds.init);
  state_ = {};
  state_.seeds = start_.seeds;
  end_.reset();
  within_.reset();
  moved_ = 0;
  show(state_.seeds);
}

void SteppedTessellation::show(const std::vector<NodeId>& seeds) {
  seeds_ = seeds;
  engine_->partition(seeds_);
}

NodeId SteppedTessellation::free_node(InputId id) const {
  const std::vector<NodeId>& node_of = start_.mesh_graph.node_of;
  const NodeId node = id < node_of.size() ? node_of[id] : no_id;
  if (node == no_id) throw InvalidInput(fmt::format("id {}: has no node in this graph", id));
  if (std::find(seeds_.begin(), seeds_.end(), node) != seeds_.end()) {
    throw InvalidInput(fmt::format("id {}: is a seed already", id));
  }
  return node;
}

void SteppedTessellation::check_region(RegionId region) const {
  if (region < seeds_.size()) return;
  throw InvalidInput(fmt::format("region {}: there are {}, counted from 0", region, seeds_.size()));
}

void SteppedTessellation::check_components(RegionId region,
                                           const std::vector<NodeId>& seeds) const {
  if (has_seeds(components_, seeds)) return;
  throw InvalidInput(fmt::format("region {}: its component would be left without a seed", region));
}

void SteppedTessellation::add_seed(InputId id) {
  const NodeId node = free_node(id);
  std::vector<NodeId> seeds = seeds_;
  seeds.push_back(node);
  begin(std::move(seeds), true);
}

void SteppedTessellation::move_seed(RegionId region, InputId id) {
  check_region(region);
  std::vector<NodeId> seeds = seeds_;
  seeds[region] = free_node(id);
  check_components(region, seeds);
  begin(std::move(seeds), true);
}

void SteppedTessellation::remove_seed(RegionId region) {
  check_region(region);
  std::vector<NodeId> seeds = seeds_;
  seeds[region] = seeds.back();
  seeds.pop_back();
  check_components(region, seeds);
  begin(std::move(seeds), true);
}

bool SteppedTessellation::step(StepKind kind, const ProgressCallback& observer) {
  if (is_done()) throw InvalidInput("the relaxation is done: reset it, or change a seed");
  if (kind == StepKind::greedy && (within_ || phase() != Phase::greedy)) {
    throw InvalidInput("the greedy phase is over: reset to take greedy steps");
  }
  if (kind == StepKind::micro) return microstep(observer);
  if (within_) {
    arrive(std::move(within_->after));
    return true;
  }
  if (kind == StepKind::macro) end_greedy_phase();
  RelaxationState state = state_;
  if (!take(state, observer, nullptr)) return false;
  arrive(std::move(state));
  return true;
}

void SteppedTessellation::end_greedy_phase() {
  if (phase() != Phase::greedy) return;
  relaxation_options_.max_greedy_steps = static_cast<std::uint32_t>(state_.steps.size());
}

bool SteppedTessellation::microstep(const ProgressCallback& observer) {
  if (!within_) {
    end_greedy_phase();
    WithinStep within;
    within.after = state_;
    if (!take(within.after, observer, &within.trails)) return false;
    show(state_.seeds);
    within_ = std::move(within);
  }
  std::size_t longest = 0;
  moved_ = 0;
  const std::size_t place = within_->microsteps++;
  for (RegionId r = 0; r < within_->trails.size(); ++r) {
    const std::vector<NodeId>& trail = within_->trails[r];
    longest = std::max(longest, trail.size());
    if (place >= trail.size()) continue;
    seeds_[r] = trail[place];
    ++moved_;
  }
  if (place + 1 >= longest) arrive(std::move(within_->after));
  return true;
}

// Where there is no step any more, the state stays and the end is known.
bool SteppedTessellation::take(RelaxationState& state, const ProgressCallback& observer,
                               SeedTrails* trails) {
  const std::optional<StopReason> end =
      take_step(start_.mesh_graph.graph, *engine_, state, relaxation_options_, observer, trails);
  if (end == StopReason::interrupted) {
    show(state_.seeds);
    return false;
  }
  end_ = end;
  return true;
}

void SteppedTessellation::arrive(RelaxationState state) {
  if (!end_ && !state.steps.empty()) moved_ = state.steps.back().seeds_moved;
  state_ = std::move(state);
  within_.reset();
  show(is_done() ? result().seeds : state_.seeds);
}

double SteppedTessellation::energy() const {
  const std::span<const Score> scores = engine_->region_scores();
  return to_energy(start_.mesh_graph.graph,
                   std::accumulate(scores.begin(), scores.end(), Score{0}));
}

std::vector<RegionSummary> SteppedTessellation::summaries() const {
  return summarise_regions(start_.mesh_graph.graph, engine_->current(), seeds_,
                           engine_->region_scores());
}

RelaxationOptions SteppedTessellation::limits() const {
  RelaxationOptions limits = relaxation_options_;
  if (is_done()) return limits;
  if (phase() == Phase::greedy) {
    limits.max_greedy_steps = static_cast<std::uint32_t>(state_.steps.size());
  }
  limits.max_macrosteps = count_steps_in(state_.steps, Phase::precise);
  return limits;
}

Relaxation SteppedTessellation::result() {
  RelaxationState state = state_;
  Relaxation relaxation = relax(start_.mesh_graph.graph, *engine_, state, limits());
  restore_partition();
  return relaxation;
}

void SteppedTessellation::restore_partition() {
  engine_->partition(within_ ? state_.seeds : seeds_);
}

}  // namespace geolloyd
