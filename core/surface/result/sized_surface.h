#pragma once

#include <functional>
#include <vector>

#include "core/mesh/mesh_edges.h"
#include "core/surface/features/small_features.h"
#include "core/surface/sizing/sizing.h"
#include "core/surface/substrate/surface_input.h"
#include "geolloyd/remesh.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

/// The surface on which sites move, and how far apart they are to be.
struct SizedSurface {
  SurfaceInput input;
  SmallFeatures small;
  Sizing sizing;
  std::vector<Metric> shape;  ///< per vertex of the mesh; empty: cells are round
};

/// Makes that surface. Refers to its arguments.
class SurfaceSizer {
 public:
  SurfaceSizer(const Mesh& mesh, const MeshEdges& edges, const RemeshOptions& options,
               const std::function<void()>& release_edges, Runtime& runtime);

  SizedSurface run();
  /// Whether creases were looked for, and found.
  [[nodiscard]] bool has_chosen_creases() const {
    return has_creases_to_choose() && features_ != other_features_;
  }
  /// After run(): the same without creases.
  SizedSurface run_without_creases();

 private:
  [[nodiscard]] bool needs_edges() const;
  SizedSurface with_equal_error(SizedSurface surface);
  void release_edges() const;
  [[nodiscard]] std::size_t count_at(double spacing) const;
  [[nodiscard]] bool has_creases_to_choose() const {
    return options_.features.creases == Creases::automatic;
  }
  [[nodiscard]] std::vector<TrianglePair> find_features(const FeatureOptions& features) const;
  [[nodiscard]] SurfaceInput make_input() const;
  [[nodiscard]] SizedSurface sized(SurfaceInput input) const;
  [[nodiscard]] SurfaceInputOptions input_options() const;

  const Mesh& mesh_;
  const MeshEdges& edges_;
  const RemeshOptions& options_;
  const std::function<void()>& release_edges_;
  Runtime& runtime_;
  Executor& executor_;
  double area_ = 0;
  Sizing sizing_;
  std::vector<TrianglePair> features_;
  std::vector<TrianglePair> other_features_;  // without creases that were found
  std::vector<Metric> shape_;
};

}  // namespace geolloyd
