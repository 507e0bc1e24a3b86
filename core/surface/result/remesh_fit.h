#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "core/surface/features/patches.h"
#include "core/surface/substrate/surface_input.h"
#include "geolloyd/remesh.h"

namespace geolloyd {

/// What a remesh is fitted to.
struct RemeshSurface {
  const Mesh& mesh;
  const SurfaceInput& input;
  const FeatureCurves& curves;
  std::span<const Metric>
      shape;  ///< per vertex of the remesh, or empty: triangles are regular in it
  std::span<const std::array<VertexId, 2>> on_curves;  ///< edges of the remesh; ascending
  bool may_glide;  ///< edges may be flipped and vertices moved for more regular ones
};

/// Takes a remesh whose vertices are on the surface to where it is closest and most regular:
/// vertices on curves first (curve_fit.h), then the others (surface_fit.h); then glides
/// (glides.h), and a fit anew. Fills in what Remesh says of that, and places. `labels` tell the
/// vertex of the remesh that each vertex of the surface belongs to. Where `keep_going` says no,
/// the first fit ends with what it has reached, and all that follows is given up.
void fit_remesh(const RemeshSurface& surface, std::vector<RegionId>& labels, Remesh& remesh,
                Executor& executor, const std::function<bool()>& keep_going);

}  // namespace geolloyd
