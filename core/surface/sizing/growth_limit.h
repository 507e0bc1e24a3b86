#pragma once

#include <vector>

#include "core/base/executor.h"
#include "core/mesh/mesh_edges.h"

namespace geolloyd {

/// Shortens lengths until none exceeds one at another vertex by more than `growth` - 1 times the
/// way along edges between them (Persson 2006). All are above 0.
void limit_growth(const Mesh& mesh, const MeshEdges& edges, double growth,
                  std::vector<double>& lengths, Executor& executor = sequential());

}  // namespace geolloyd
