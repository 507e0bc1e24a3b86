#pragma once

#include <cstddef>

#include "core/mesh/mesh.h"
#include "core/mesh/mesh_edges.h"
#include "geolloyd/measure.h"

namespace geolloyd {

/// The smallest angle of a triangle, in degrees: 60 where it is equilateral, 0 where it is without
/// area or names a vertex twice.
double smallest_angle(const Mesh& mesh, const Triangle& triangle);

/// Q = 6 / sqrt(3) * area / (half the perimeter * longest edge) (Frey and Borouchaki 1999): 1 where
/// the triangle is equilateral, 0 where it is without area or names a vertex twice.
double triangle_quality(const Mesh& mesh, const Triangle& triangle);

/// Triangles without area, but for rounding: those that name a vertex twice, and those lower than a
/// millionth of their longest edge.
std::size_t count_flat(const Mesh& mesh);

/// Edges at which a surface turns back on itself: the normals of their two triangles, oriented
/// alike, enclose more than 150 degrees. Triangles without area have no normal.
std::size_t count_folds(const Mesh& mesh, const MeshEdges& edges);

MeshQuality measure_quality(const Mesh& mesh, const MeshEdges& edges);

}  // namespace geolloyd
