#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/executor.h"
#include "core/surface/features/feature_curves.h"
#include "core/surface/substrate/surface_input.h"

namespace geolloyd {

using PatchId = std::uint32_t;

/// A region of the surface bounded by boundary and feature edges. No free site's cell leaves it.
struct Patch {
  double area = 0;                        ///< FineMesh::sized_area()
  std::int64_t euler_characteristic = 0;  ///< cut open along curves, sub-resolution holes closed
  bool is_closed = true;                  ///< no curve runs along it
};

struct Patches {
  std::vector<Patch> patches;
  std::vector<PatchId> of_vertex;  ///< per vertex; on curves, the patch of least area there
  std::vector<std::vector<PatchId>> beside;  ///< per curve: on either side; one at the boundary
};

/// Patches are numbered by their first triangles.
Patches find_patches(const SurfaceInput& input, const FeatureCurves& curves,
                     Executor& executor = sequential());

/// A surface, and what its boundary and features make of it. Refers to `input`.
struct DividedSurface {
  const SurfaceInput& input;
  FeatureCurves curves;
  Patches patches;

  /// For sites `spacing` apart.
  DividedSurface(const SurfaceInput& of, double spacing, bool may_have_subresolution_holes,
                 Executor& executor = sequential())
      : input(of),
        curves(find_feature_curves(of, spacing, may_have_subresolution_holes)),
        patches(find_patches(of, curves, executor)) {}
};

}  // namespace geolloyd
