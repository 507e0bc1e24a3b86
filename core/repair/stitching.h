#pragma once

#include "core/repair/mesh_under_repair.h"

namespace geolloyd {

/// Joins pairs of boundary edges whose ends are in the same places, and so merges the ends. A pair
/// is joined if no other edge is in its place, or if no other edge of its component is. The mesh is
/// a manifold and stays one; no component gets more boundary loops than its parts had. Where that
/// would happen, pairs stay apart. Returns, per vertex, the vertex that it becomes: the smallest of
/// those merged. O(n log n).
std::vector<VertexId> stitch_boundaries(Mesh& mesh);

}  // namespace geolloyd
