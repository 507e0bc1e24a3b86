#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/mesh/mesh.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/metric.h"
#include "geolloyd/quality.h"

namespace geolloyd {

using TriangleCorners = std::array<Vec3, 3>;

/// As they are; or, with a metric per vertex, those of a triangle whose sides, angles and area are
/// what the mean metric of the corners measures.
TriangleCorners corners_of(const Mesh& mesh, const Triangle& triangle,
                           std::span<const Metric> metric = {});

/// The smallest angle of a triangle, in degrees: 60 where it is equilateral, 0 where it is without
/// area or names a vertex twice.
double smallest_angle(const TriangleCorners& corners);
/// The cosine of it.
double cosine_of_smallest_angle(const TriangleCorners& corners);

/// Q = 6 / sqrt(3) * area / (half the perimeter * longest edge) (Frey and Borouchaki 1999): 1 where
/// the triangle is equilateral, 0 where it is without area or names a vertex twice.
double triangle_quality(const TriangleCorners& corners);

/// Triangles without area, but for rounding: those that name a vertex twice, and those lower than a
/// millionth of their longest edge.
std::size_t count_flat(const Mesh& mesh);

/// Edges at which a surface turns back on itself: the normals of their two triangles, oriented
/// alike, enclose more than 150 degrees. Triangles without area have no normal.
std::size_t count_folds(const Mesh& mesh, const MeshEdges& edges);

/// In a metric per vertex, if there is one.
MeshQuality measure_quality(const Mesh& mesh, const MeshEdges& edges,
                            std::span<const Metric> metric = {});

}  // namespace geolloyd
