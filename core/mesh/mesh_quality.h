#pragma once

#include <cstddef>
#include <limits>

#include "core/mesh/mesh.h"
#include "core/mesh/mesh_edges.h"

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

/// The figures by which remeshes are compared. Every triangle of the mesh counts, degenerate and
/// duplicate ones as well. A vertex is inner where each of its edges, at least one, has exactly two
/// triangles; its valence is the number of these edges. Without triangles, or without inner
/// vertices, what is a mean or a share of them is not a number.
struct MeshQuality {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  double smallest_angle = none;       ///< of all triangles, degrees
  double mean_smallest_angle = none;  ///< mean of each triangle's smallest one, degrees
  double share_under_30 = none;       ///< of triangles whose smallest angle is under 30 degrees
  double smallest_quality = none;
  double mean_quality = none;
  std::size_t inner_vertices = 0;
  double share_valence_6 = none;       ///< of inner vertices
  double share_valence_5_to_7 = none;  ///< of inner vertices
};

MeshQuality measure_quality(const Mesh& mesh, const MeshEdges& edges);

}  // namespace geolloyd
