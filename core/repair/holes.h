#pragma once

#include "core/repair/mesh_under_repair.h"
#include "geolloyd/repair.h"

namespace geolloyd {

enum class Touching { joined, left };

/// Fills the small holes of a manifold with triangles that come last, hole after hole in order of
/// their first vertices. Holes that touch at a vertex were one loop with the vertex cut in two;
/// each is filled alone, which joins the vertices again, or left. Returns, per vertex, that which
/// it becomes: the smallest of those joined. A hole is left as well where its triangles would fold,
/// be slivers, have an edge that is there already, or pass through the surface. Near-linear.
std::vector<VertexId> fill_holes(Mesh& mesh, const RepairOptions& options, Touching touching,
                                 Repairs& repairs);

}  // namespace geolloyd
