#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/regions/graph_dual.h"
#include "geolloyd/remesh.h"
#include "tools/evaluation/ground_truth.h"
#include "tools/files/json.h"
#include "tools/render/surface_colours.h"
#include "tools/view/bundle.h"
#include "tools/view/session/session_command.h"
#include "tools/view/session/stepped_tessellation.h"

namespace geolloyd {

/// A surface remesh that is being made, or has been.
struct SessionRemesh {
  std::size_t vertices = 0;  ///< asked for
  std::filesystem::path field;
  RemeshProgress progress;
  std::vector<Vec3> sites;     ///< mesh units, while they move
  std::optional<Remesh> made;  ///< once it is there
};

/// All that a session is about, and what commands do to it, one after the other. What throws Error
/// leaves all as it was. Not for two threads at once.
class SessionModel {
 public:
  /// `output` may be empty: then nothing can be saved. It has been prepared (saving.h). `runtime`
  /// must live on.
  SessionModel(LoadedInput loaded, const SessionOptions& options, std::filesystem::path output,
               Runtime& runtime);

  /// Does what `command` says; `run`, `pause` and `stop` are not its. `keep_going` is asked now and
  /// then, and false ends a step, which then was not taken, or the moving of a remesh's sites.
  void perform(const SessionCommand& command, const std::function<bool()>& keep_going);
  /// Grows with each change.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  [[nodiscard]] bool is_done() const { return tessellation_.is_done(); }
  /// Of a run. False where `keep_going` ended it.
  bool take_step(const std::function<bool()>& keep_going);

  /// What the browser is told at once. `task`: null, or what is being done. The fingerprint takes
  /// some time; it is left out of a run.
  [[nodiscard]] Json state(const Json& task, bool is_running);
  void set_message(const std::string& kind, const std::string& text);

  /// A bundle: "mesh", or one of the layers that state() names. Throws InvalidInput for others.
  [[nodiscard]] std::string bundle(std::string_view name);

  // For tests and for what is saved.
  [[nodiscard]] SteppedTessellation& tessellation() { return tessellation_; }
  [[nodiscard]] const std::optional<SessionRemesh>& remesh() const { return remesh_; }

 private:
  void make_truth();
  void make_dual();
  void make_remesh(std::size_t vertices, const std::function<bool()>& keep_going);
  void save(Saving what);
  void seeds_changed();
  const std::vector<Colour>& region_colours();
  void touch(const std::string& layer) { layers_[layer] = ++revision_; }
  [[nodiscard]] std::filesystem::path remesh_field() const;
  [[nodiscard]] Json remesh_part() const;

  SteppedTessellation tessellation_;
  std::filesystem::path output_;
  std::filesystem::path field_file_;
  Runtime& runtime_;
  SurfaceColours colours_;
  Placement placement_;
  Json mesh_facts_;
  std::vector<Colour> region_colours_;
  std::optional<GroundTruth> truth_;
  std::optional<GraphDual> dual_;
  std::optional<SessionRemesh> remesh_;
  std::uint64_t revision_ = 0;
  std::map<std::string, std::uint64_t> layers_;  // those that are there, and when they changed
  Json message_;
};

}  // namespace geolloyd
