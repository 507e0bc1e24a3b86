#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/mesh_edges.h"

namespace geolloyd {

/// The self-intersections of a mesh: pairs of triangles that cross, as crossing_triangles.h has it;
/// ascending. Where a triangle crosses more than a hundred others, some of its pairs may be left
/// out.
std::vector<TrianglePair> find_crossings(const Mesh& mesh, Executor& executor = sequential());

/// The corners of these, per vertex.
void mark_corners(const Mesh& mesh, std::span<const TrianglePair> pairs,
                  std::vector<std::uint8_t>& marked);

}  // namespace geolloyd
