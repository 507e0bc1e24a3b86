#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/mesh_edges.h"

namespace geolloyd {

/// Per vertex, 1 where its triangles surely have nothing in common but their common edges and the
/// vertex: they go once around it, and seen along some axis lie side by side. So none of them
/// cross, as nearly everywhere on a surface.
std::vector<std::uint8_t> find_plain_stars(const Mesh& mesh, Executor& executor = sequential());

}  // namespace geolloyd
