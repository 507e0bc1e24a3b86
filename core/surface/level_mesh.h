#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/coarse_mesh.h"
#include "core/surface/outer_chains.h"
#include "core/surface/surface_input.h"

namespace geolloyd {

/// A mesh on which the sites of one level move: the fine mesh, or a coarser one.
struct LevelMesh {
  const FineMesh* mesh = nullptr;
  std::vector<std::uint32_t> part;       ///< per vertex
  std::vector<VertexId> outer_vertices;  ///< those that stand for OuterChains::vertices
  std::vector<std::uint8_t> is_outer;    ///< per vertex: stands for one of them
};

/// That of the last level.
LevelMesh fine_level(const SurfaceInput& input, const OuterChains& outer);

/// The fine mesh, and coarser ones for sites farther apart.
class LevelMeshes {
 public:
  /// `spacings` ascend.
  LevelMeshes(const SurfaceInput& input, const OuterChains& outer, std::span<const double> spacings,
              Executor& executor = sequential());

  [[nodiscard]] const LevelMesh& fine() const { return levels_[0]; }
  /// For sites so far apart.
  [[nodiscard]] const LevelMesh& at(std::size_t spacing) const { return levels_[of_[spacing]]; }
  /// Per vertex of `finer`: what stands for it in `coarser`.
  [[nodiscard]] std::vector<VertexId> map(const LevelMesh& finer, const LevelMesh& coarser) const;

 private:
  void add_coarser(double spacing, Executor& executor);

  std::vector<double> area_;        // per part
  std::vector<LevelMesh> levels_;   // from fine to coarse
  std::vector<CoarseMesh> coarse_;  // of level i + 1, made of level i
  std::vector<std::size_t> of_;     // per spacing: its level
};

}  // namespace geolloyd
