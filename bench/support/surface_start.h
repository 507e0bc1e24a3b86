#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/mesh/mesh_edges.h"
#include "core/surface/patches.h"
#include "core/surface/site_levels.h"
#include "core/surface/surface_input.h"

namespace geolloyd {

/// How fine the surface for so many sites is, as make_surface_remesh has it.
struct SurfaceFineness {
  double area = 0;          ///< mesh units
  double longest_edge = 0;  ///< mesh units
  std::size_t vertex_limit = 0;

  [[nodiscard]] SurfaceInputOptions options(std::span<const TriangleId> duplicates) const;
};

SurfaceFineness surface_fineness(const Mesh& mesh, const MeshEdges& edges, std::size_t sites);

/// What the stages of a surface remesh start from, as the reference engine left it.
struct SurfaceStart {
  std::unique_ptr<const SurfaceInput> whole;
  std::unique_ptr<const DividedSurface> divided;
  std::vector<double> spacings;  ///< of the levels, ascending
  RestingSites resting;          ///< on the fine mesh
  double energy = 0;             ///< of them

  [[nodiscard]] const SurfaceInput& input() const { return *whole; }
  [[nodiscard]] const DividedSurface& surface() const { return *divided; }
};

SurfaceStart make_surface_start(const Mesh& mesh, const MeshEdges& edges, std::size_t sites);

}  // namespace geolloyd
