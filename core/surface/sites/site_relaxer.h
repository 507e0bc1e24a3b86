#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/stopwatch.h"
#include "core/surface/cells/surface_engine.h"
#include "core/surface/sites/level_mesh.h"
#include "core/surface/sites/surface_sites.h"
#include "core/surface/substrate/surface_input.h"
#include "geolloyd/remesh.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

/// Sites, and the label of each vertex of the mesh that they move on.
struct LabelledSites {
  SurfaceSites sites;
  std::vector<RegionId> labels;
};

/// Moves sites on one mesh after the other, and keeps the record of it.
class SiteRelaxer {
 public:
  /// Of sites on this surface. All must live on.
  SiteRelaxer(const SurfaceInput& input, const RemeshOptions& options, Runtime& runtime,
              bool finds_sizes = false);

  /// What progress is told.
  void set_wanted_sites(std::size_t count) { wanted_sites_ = count; }
  /// Leaves each cell in one piece, then sweeps.
  void sweep(const LevelMesh& level, LabelledSites& state);
  /// Moves free sites downhill; after an interrupt, only sweeps. Returns the energy.
  double relax(const LevelMesh& level, LabelledSites& state, std::size_t iterations);
  /// Between moves: whether to go on. Progress is told where sites are, and the rest as before.
  bool ask(const SurfaceSites& sites);
  /// Gives the engine's memory back, until something is relaxed again.
  void release_engine() {
    engine_.reset();
    mesh_ = nullptr;
  }
  /// Moments of the cells after the last sweep.
  [[nodiscard]] const Cells& cells() const { return engine_->cells(); }

  [[nodiscard]] bool is_interrupted() const { return is_interrupted_; }
  [[nodiscard]] const std::vector<SurfaceStep>& steps() const { return steps_; }
  [[nodiscard]] std::uint64_t fingerprint() const { return fingerprint_; }

 private:
  SurfaceEngine& engine_for(const LevelMesh& level);
  bool record(const LevelMesh& level, std::size_t iteration, double energy,
              std::span<const Vec3> sites);
  void tell_progress(std::span<const Vec3> sites);
  void add_to_fingerprint(const LabelledSites& state);

  const SurfaceInput& input_;
  const RemeshOptions& options_;
  Runtime& runtime_;
  bool finds_sizes_;  // what progress is told, too
  const FineMesh* mesh_ = nullptr;
  std::unique_ptr<SurfaceEngine> engine_;  // on it
  Stopwatch watch_;
  std::vector<SurfaceStep> steps_;
  std::uint64_t fingerprint_ = 0;
  bool is_interrupted_ = false;
  std::size_t wanted_sites_ = 0;
  std::size_t iteration_ = 0;  // the latest
  double energy_ratio_ = 0;
};

}  // namespace geolloyd
