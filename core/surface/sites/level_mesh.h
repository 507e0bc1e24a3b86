#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/features/patches.h"
#include "core/surface/substrate/coarse_mesh.h"

namespace geolloyd {

/// A mesh on which the sites of one level move: the fine mesh, or a coarser one.
struct LevelMesh {
  const FineMesh* mesh = nullptr;
  std::span<const PatchId> patch;         ///< per vertex; somebody else's
  std::vector<VertexId> curve_vertices;   ///< those that stand for FeatureCurves::vertices
  std::vector<std::uint8_t> is_on_curve;  ///< per vertex: stands for one of them
};

/// That of the last level.
LevelMesh fine_level(const DividedSurface& surface);

/// The fine mesh, and coarser ones for sites farther apart.
class LevelMeshes {
 public:
  /// `spacings` ascend.
  LevelMeshes(const DividedSurface& surface, std::span<const double> spacings,
              Executor& executor = sequential());

  [[nodiscard]] const LevelMesh& fine() const { return levels_[0]; }
  /// For sites so far apart.
  [[nodiscard]] const LevelMesh& at(std::size_t spacing) const { return levels_[of_[spacing]]; }
  /// Gives back the memory of all coarser ones.
  void forget_coarser();
  /// Per vertex of `finer`: what stands for it in `coarser`.
  [[nodiscard]] std::vector<VertexId> map(const LevelMesh& finer, const LevelMesh& coarser) const;

 private:
  // `curve`: per vertex of the coarsest level, its corner, or else its curve, from 1; or 0.
  void add_coarser(double spacing, std::vector<std::uint32_t>& curve, Executor& executor);
  void close_features(CoarseMesh& coarse) const;

  const DividedSurface& surface_;
  std::vector<LevelMesh> levels_;            // from fine to coarse
  std::vector<CoarseMesh> coarse_;           // of level i + 1, made of level i
  std::vector<std::vector<PatchId>> patch_;  // the same levels'
  std::vector<std::size_t> of_;              // per spacing: its level
};

}  // namespace geolloyd
