#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/surface/cells/surface_engine.h"

namespace geolloyd {

/// What pairs of engines have compared so far, on all meshes of a remesh.
struct SurfaceComparison {
  std::size_t meshes = 0;  ///< one per pair
  std::size_t evaluations = 0;
  std::uint64_t labels = 0;     ///< of all evaluations
  std::uint64_t cells = 0;      ///< of all evaluations
  double expected_seconds = 0;  ///< wall time each engine has taken
  double tested_seconds = 0;
};

/// Has two engines do everything, compares all labels and moments after each evaluation, and goes
/// on with the first engine's. Throws Disagreement (core/lloyd/paired_engine.h, no node) at the
/// first difference, which names evaluation, place and both values.
class PairedSurfaceEngine final : public SurfaceEngine {
 public:
  /// Both of the same mesh. `comparison` must live on.
  PairedSurfaceEngine(std::unique_ptr<SurfaceEngine> expected,
                      std::unique_ptr<SurfaceEngine> tested, SurfaceComparison& comparison);

  void assign(std::vector<RegionId> labels, std::span<const std::uint8_t> is_fixed) override;
  const Cells& evaluate(std::span<const Vec3> sites) override;
  [[nodiscard]] const std::vector<RegionId>& labels() const override { return expected_->labels(); }
  [[nodiscard]] const Cells& cells() const override { return expected_->cells(); }

 private:
  [[noreturn]] void differ(const std::string& what, const std::string& expected,
                           const std::string& tested) const;
  void compare_labels() const;
  void compare_moments(const Cells& expected, const Cells& tested) const;

  std::unique_ptr<SurfaceEngine> expected_;
  std::unique_ptr<SurfaceEngine> tested_;
  SurfaceComparison& comparison_;
  std::size_t mesh_;  // its number, from 1
};

}  // namespace geolloyd
