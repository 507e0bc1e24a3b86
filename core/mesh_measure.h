#pragma once

#include <span>
#include <vector>

#include "core/mesh.h"
#include "core/mesh_edges.h"

namespace geolloyd {

/// Triangles with the same three vertices as an earlier one, ascending.
std::vector<TriangleId> duplicate_triangles(const Mesh& mesh, const MeshEdges& edges);

/// Area of each triangle, square mesh units; 0 for `duplicates`, so that they count once, and for
/// triangles naming a vertex twice.
std::vector<double> triangle_areas(const Mesh& mesh, std::span<const TriangleId> duplicates);

/// A third of the area of the triangles around each vertex. Sums to the surface's area.
std::vector<double> vertex_areas(const Mesh& mesh, const std::vector<double>& triangle_area);

/// Mean of the three corners.
Vec3 barycentre(const Mesh& mesh, TriangleId triangle);

}  // namespace geolloyd
