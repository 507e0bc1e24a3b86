#pragma once

#include <cstddef>

#include "tools/view/bundle.h"

namespace geolloyd {

/// Leaves at most `vertex_limit` vertices of the mesh, at least one: of those in one cell of a
/// grid the one nearest to their mean stands for all, and triangles whose corners have become one
/// go. What belongs to vertices and triangles is that of those which stay; trees are left out.
void simplify(Bundle& bundle, std::size_t vertex_limit);

}  // namespace geolloyd
