#pragma once

#include <cstddef>

#include "core/mesh/mesh.h"

namespace geolloyd::zoo {

/// Pairs of triangles that go through each other, or overlap in one plane (crossing_triangles.h).
/// Those with a vertex in common do not count, nor do those that merely touch.
std::size_t count_crossings(const Mesh& mesh);

}  // namespace geolloyd::zoo
