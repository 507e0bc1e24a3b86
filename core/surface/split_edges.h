#pragma once

#include <vector>

#include "core/mesh/mesh.h"

namespace geolloyd {

/// Halves edges that are longer than `longest` times the smaller size of their ends, and the
/// triangles at them with them, again and again until none is, or the mesh has `vertex_limit`
/// vertices. Edges that coordinates are too coarse to halve stay. `origin` has an entry per
/// triangle; pieces inherit it. `sizes` has one per vertex, or none where all are 1; a middle has
/// the mean of its ends. All triangles have three vertices.
void split_long_edges(Mesh& mesh, std::vector<TriangleId>& origin, std::vector<double>& sizes,
                      double longest, std::size_t vertex_limit);

}  // namespace geolloyd
