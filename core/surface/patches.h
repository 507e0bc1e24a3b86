#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/executor.h"
#include "core/surface/chains.h"
#include "core/surface/surface_input.h"

namespace geolloyd {

using PatchId = std::uint32_t;

/// A piece of surface that boundary and features leave in one. No free site's cell leaves it.
struct Patch {
  double area = 0;                        ///< FineMesh::sized_area()
  std::int64_t euler_characteristic = 0;  ///< cut open along chains, pinholes closed
  bool is_closed = true;                  ///< no chain runs along it
};

struct Patches {
  std::vector<Patch> patches;
  std::vector<PatchId> of_vertex;  ///< per vertex; on chains, the patch of least area there
  std::vector<std::vector<PatchId>> beside;  ///< per chain: on either side; one at the boundary
};

/// Patches are numbered by their first triangles.
Patches find_patches(const SurfaceInput& input, const Chains& chains,
                     Executor& executor = sequential());

/// A surface, and what its boundary and features make of it. Refers to `input`.
struct DividedSurface {
  const SurfaceInput& input;
  Chains chains;
  Patches patches;

  /// For sites `spacing` apart.
  DividedSurface(const SurfaceInput& of, double spacing, bool may_have_pinholes,
                 Executor& executor = sequential())
      : input(of),
        chains(find_chains(of, spacing, may_have_pinholes)),
        patches(find_patches(of, chains, executor)) {}
};

}  // namespace geolloyd
