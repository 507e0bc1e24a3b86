#pragma once

#include <span>

#include "core/base/executor.h"
#include "core/mesh/mesh.h"

namespace geolloyd {

/// Euclidean energy of `sites`, at least one, on a surface: the integral over its triangles of the
/// squared distance to the nearest site, in mesh units to the fourth power. However finely the
/// surface is cut into triangles, the energy is the same. Triangles that name a vertex twice and
/// `duplicates` (mesh_edges.h) count nothing.
///
/// Exact but for rounding, which is 1e-12 of the energy unless coordinates are far larger than the
/// mesh. A triangle that crosses borders of the sites' Voronoi cells is cut along them; over a
/// piece in one cell the integral has a closed form. The same for any number of threads.
double site_energy(const Mesh& mesh, std::span<const TriangleId> duplicates,
                   std::span<const Vec3> sites, Executor& executor = sequential());

}  // namespace geolloyd
