#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "core/lloyd/engine.h"
#include "tools/render/picture.h"
#include "tools/run/stages.h"

namespace geolloyd {

/// Makes the folder that --frames names. Throws Error where it cannot be written or holds frames of
/// another run: these are not ours to remove, and must not be taken for frames of this one. (A run
/// that is resumed goes on among its own.)
void prepare_frames(const RelaxArguments& arguments);

/// Has another engine do everything, and draws the regions at the start of each step into a file:
/// 000-greedy.png, 001-greedy.png ..., 012-precise.png. A region has one colour in all of them.
class FramesEngine final : public Engine {
 public:
  /// Of a relaxation after `steps`. All but these must live on.
  FramesEngine(Engine& engine, const RelaxArguments& arguments, const Start& start,
               Executor& executor, std::span<const Step> steps);

  void partition(std::span<const NodeId> seeds) override { engine_.partition(seeds); }
  [[nodiscard]] std::span<const Score> region_scores() const override {
    return engine_.region_scores();
  }
  [[nodiscard]] std::uint64_t state_digest(std::span<const NodeId> seeds) const override {
    return engine_.state_digest(seeds);
  }
  std::vector<NodeId> greedy_candidates(std::span<const NodeId> seeds, bool extended) override;
  std::vector<Microstep> macrostep(std::vector<NodeId>& seeds, const MacrostepOptions& options,
                                   const KeepGoing& keep_going) override;
  [[nodiscard]] const Partition& current() const override { return engine_.current(); }
  [[nodiscard]] const KernelSeconds& seconds() const override { return engine_.seconds(); }

 private:
  void draw(std::span<const NodeId> seeds, Phase phase);

  Engine& engine_;
  const std::filesystem::path& folder_;
  const MeshGraph& mesh_graph_;
  Executor& executor_;
  Picture picture_;
  std::vector<Colour> colours_;
  std::uint32_t frames_;
  std::uint32_t greedy_frames_;
};

}  // namespace geolloyd
