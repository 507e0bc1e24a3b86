#pragma once

#include <cstdint>

#include "core/mesh/mesh.h"

namespace geolloyd {

// Subdivisions keep the surface and the orientation. Old vertices keep their ids; those on edges
// come next, in order of edge (mesh_edges.h), then those inside triangles. Triangles naming a
// vertex twice are dropped. Throws InvalidInput where the result would need more than 32-bit ids.

/// Each triangle in `frequency`^2 similar ones; `frequency` >= 1.
Mesh refine(const Mesh& mesh, std::uint32_t frequency);

/// Each triangle in four, by the midpoints of its edges.
Mesh subdivide_midpoint(const Mesh& mesh);

/// Each triangle in six, by its barycentre and the midpoints of its edges.
Mesh subdivide_barycentric(const Mesh& mesh);

}  // namespace geolloyd
