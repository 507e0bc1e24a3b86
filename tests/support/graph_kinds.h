#pragma once

#include <array>

#include "core/graph/mesh_graph.h"

namespace geolloyd {

inline constexpr std::array all_kinds = {GraphKind::vertex,   GraphKind::vertex_dense,
                                         GraphKind::triangle, GraphKind::triangle_dense,
                                         GraphKind::mixed,    GraphKind::vertex_far};

}  // namespace geolloyd
