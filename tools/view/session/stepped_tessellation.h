#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/graph/components.h"
#include "core/lloyd/relaxation.h"
#include "core/regions/tessellation.h"
#include "geolloyd/runtime.h"
#include "tools/run/stages.h"
#include "tools/view/session/session_options.h"

namespace geolloyd {

/// One step of a relaxation as a user asks for it.
enum class StepKind {
  any,     ///< a greedy step or a macrostep, whichever comes next
  greedy,  ///< only as long as there was no macrostep
  macro,   ///< ends the greedy phase
  micro    ///< one move of each seed that moves; ends the greedy phase, too
};

/// A mesh, its graph, first seeds that can be edited, and their relaxation, step by step. What
/// throws InvalidInput leaves all as it was. Not for two threads at once.
class SteppedTessellation {
 public:
  /// Builds the graph and chooses the seeds: 256 where no number is given, or fewer on few nodes.
  /// `runtime` must live on.
  SteppedTessellation(LoadedInput loaded, const SessionOptions& options, Runtime& runtime);

  // What changes the first seeds begins their relaxation anew.

  /// Edited seeds stay if the new options choose seeds as before, and all have nodes in the graph.
  void set(const SessionOptions& options);
  /// As the options say: edits are lost.
  void choose_seeds();
  /// At the node of an input id.
  void add_seed(InputId id);
  void move_seed(RegionId region, InputId id);
  /// The region's number goes to the last one.
  void remove_seed(RegionId region);
  /// Back to the first seeds.
  void reset();

  /// False where `observer` stopped the step, which then was not taken.
  bool step(StepKind kind, const ProgressCallback& observer = {});

  [[nodiscard]] const PreparedInput& start() const { return start_; }
  [[nodiscard]] const MeshEdges& edges() const { return edges_; }
  [[nodiscard]] const std::vector<TangentSpace>& field() const { return field_; }
  [[nodiscard]] const SessionOptions& options() const { return options_; }
  [[nodiscard]] Engine& engine() { return *engine_; }

  /// Seeds as they are to be seen: between two microsteps, those after the last one.
  [[nodiscard]] const std::vector<NodeId>& seeds() const { return seeds_; }
  /// Of the seeds at the start of the step that microsteps are part of, else of seeds().
  [[nodiscard]] const Partition& partition() const { return engine_->current(); }
  [[nodiscard]] double energy() const;
  /// Of the partition's regions.
  [[nodiscard]] std::vector<RegionSummary> summaries() const;
  [[nodiscard]] const std::vector<Step>& steps() const { return state_.steps; }
  /// Seeds that moved in the last step or microstep.
  [[nodiscard]] std::size_t moved() const { return moved_; }
  [[nodiscard]] Phase phase() const { return next_phase(state_, relaxation_options_); }
  [[nodiscard]] bool is_done() const { return end_ || phase() == Phase::improvement; }
  /// Between two microsteps of one macrostep.
  [[nodiscard]] bool is_within_step() const { return within_.has_value(); }
  [[nodiscard]] bool has_edited_seeds() const { return has_edited_seeds_; }

  /// Options with which `relax` ends where this is now, but for the first seeds.
  [[nodiscard]] RelaxationOptions limits() const;
  /// That relaxation, from the last whole step.
  Relaxation result();
  /// The engine gets the partition back that is to be seen, after others worked with it.
  void restore_partition();

 private:
  struct Made;
  // A macrostep that was taken, and how much of it has been shown.
  struct WithinStep {
    RelaxationState after;
    SeedTrails trails;
    std::size_t microsteps = 0;
  };

  void rebuild(SessionOptions options, bool chooses_anew);
  std::vector<NodeId> choose(const SessionOptions& options, const Made* made);
  void begin(std::vector<NodeId> first_seeds, bool are_edited);
  [[nodiscard]] NodeId free_node(InputId id) const;
  void check_region(RegionId region) const;
  void check_components(RegionId region, const std::vector<NodeId>& seeds) const;
  bool take(RelaxationState& state, const ProgressCallback& observer, SeedTrails* trails);
  bool microstep(const ProgressCallback& observer);
  void arrive(RelaxationState state);
  void end_greedy_phase();
  void show(const std::vector<NodeId>& seeds);

  Runtime& runtime_;
  PreparedInput start_;  // its seeds are the first ones
  MeshEdges edges_;
  SessionOptions options_;
  std::vector<TangentSpace> field_;
  Components components_;
  std::unique_ptr<Engine> engine_;
  RelaxationOptions relaxation_options_;
  RelaxationState state_;
  std::optional<StopReason> end_;
  std::optional<WithinStep> within_;
  std::vector<NodeId> seeds_;
  std::size_t moved_ = 0;
  bool has_edited_seeds_ = false;
};

}  // namespace geolloyd
