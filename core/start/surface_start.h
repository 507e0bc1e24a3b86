#pragma once

#include <memory>
#include <span>

#include "core/mesh/mesh.h"
#include "core/surface/features/patches.h"
#include "core/surface/sites/site_levels.h"
#include "core/surface/substrate/surface_input.h"
#include "geolloyd/choices.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

/// Sites that have come to rest on the surface of a mesh, and that surface: its features are no
/// features to them, its boundary is.
struct SurfaceStart {
  std::unique_ptr<const SurfaceInput> whole;
  std::unique_ptr<const DividedSurface> divided;
  RestingSites resting;  ///< on the fine mesh

  [[nodiscard]] const SurfaceInput& input() const { return *whole; }
  [[nodiscard]] const DividedSurface& surface() const { return *divided; }
};

/// How fine the surface for so many sites is: each cell has some vertices.
SurfaceInputOptions surface_options(const Mesh& mesh, std::span<const TriangleId> duplicates,
                                    double area, std::size_t sites);

/// Whether sites can follow this field: its magnitudes are above 0, none is over 100 times the
/// other of its vertex, and their products differ by no more than the square of 1e6.
bool can_spread(std::span<const TangentSpace> field);

/// The mesh has an area. There are `sites` of them, or the least that its parts need. They are
/// spread by the metric of `field`, if there is one, which they can follow.
SurfaceStart make_surface_start(const Mesh& mesh, std::span<const TriangleId> duplicates,
                                double area, std::size_t sites, std::span<const TangentSpace> field,
                                const RestEffort& effort, Runtime& runtime);

}  // namespace geolloyd
