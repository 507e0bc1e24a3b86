#pragma once

#include <vector>

#include "core/mesh/mesh.h"

namespace geolloyd {

/// Joins pairs of boundary edges whose ends are in the same places, and so merges the ends. A pair
/// is joined if no other edge is in its place, or if no other edge of its component is. The mesh is
/// a manifold and stays one; no component gets more boundary loops than its parts had. Where that
/// would happen, pairs stay apart. Returns, per vertex, the vertex that it becomes: the smallest of
/// those merged. O(n log n).
std::vector<VertexId> stitch_boundaries(Mesh& mesh);

/// Finds vertices that are in the very same place (-0 is 0) because a file splits them, as where a
/// corner has several normals. The same pairs of boundary edges are joined, but a surface may get
/// more loops by it, as a sheet that becomes a tube. Surfaces that merely touch stay apart: closed
/// ones, as they have no boundary; the front and the back of a sheet, two triangles on each other;
/// and all that three triangles would come to meet at an edge of, or two triangles to have the same
/// vertices. Returns, per vertex, the vertex that it is to become, or nothing where none is split.
/// Near-linear where no two vertices are in one place, else O(n log n).
std::vector<VertexId> find_split_vertices(const Mesh& mesh);

/// Per vertex the smallest vertex that it is connected to by edges.
std::vector<VertexId> components_of(const Mesh& mesh);

/// Renames vertices in all triangles.
void rename_vertices(Mesh& mesh, const std::vector<VertexId>& name);

}  // namespace geolloyd
