#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/mesh_edges.h"

namespace geolloyd {

/// Pairs of triangles that pass through each other, or overlap in one plane
/// (crossing_triangles.h); ascending. Those with a vertex in common do not count, nor do those that
/// merely touch.
std::vector<TrianglePair> find_crossings(const Mesh& mesh, Executor& executor = sequential());

/// The corners of these, per vertex.
void mark_corners(const Mesh& mesh, std::span<const TrianglePair> pairs,
                  std::vector<std::uint8_t>& marked);

}  // namespace geolloyd
