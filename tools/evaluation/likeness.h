#pragma once

#include <cstddef>
#include <span>

#include "core/base/executor.h"
#include "core/mesh/mesh.h"
#include "geolloyd/evaluation.h"

namespace geolloyd {

/// A remesh beside the mesh that it stands for.
struct Likeness {
  std::size_t samples = 0;   ///< on each of the two
  SurfaceDistance distance;  ///< first the remesh, second the original
  double energy = 0;         ///< of sites at the original's points closest to the remesh's vertices
                             ///< (site_energy.h)
  double hexagonal = 0;      ///< that of the hexagonal tiling with as many regions
};

/// `duplicates` are the original's, `area` that of its surface. Both meshes have an area.
Likeness compare(const Mesh& remesh, const Mesh& original, std::span<const TriangleId> duplicates,
                 double area, std::size_t samples, Executor& executor);

}  // namespace geolloyd
